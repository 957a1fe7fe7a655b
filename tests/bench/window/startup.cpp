// startup_bench: how long the editor takes to its first frame, which is the panels round an empty
// canvas, and to the second, which has the curves, beside the first frame of a bare program of GLFW
// and Dear ImGui. Each is started anew, several times in turn; it ends when the frame is on the
// screen.
//
// startup_bench editor [FILE], curves [FILE], and bare are what it starts.
#include "app/files.h"
#include "app/loop.h"
#include "app/storage/keeper.h"

// glad comes before GLFW, which would bring in the system's OpenGL header.
#include <glad/gl.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

extern "C" void __real_glfwSwapBuffers(GLFWwindow* window);

namespace splineloft::app {
namespace {

constexpr int rounds = 15;

int framesToShow = 1;

void runEditorToFirstFrame(const std::vector<std::string>& files) {
    const auto folder = std::filesystem::temp_directory_path() / "splineloft-startup-bench";
    Keeper keeper({folder / "config", folder / "state"});
    auto session = beginSession(files);
    keeper.begin(*session, files);
    runEditor(*session, keeper);
}

void runBareToFirstFrame() {
    glfwInit();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLFWwindow* window = glfwCreateWindow(1280, 800, "bare", nullptr, nullptr);
    glfwMakeContextCurrent(window);
    gladLoadGL(glfwGetProcAddress);
    ImGui::CreateContext();
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    // Of this size: one that finds its own would be hidden in the first frame, which would be
    // empty.
    ImGui::SetNextWindowSize({400, 300});
    ImGui::Begin("bare");
    ImGui::TextUnformatted("Some words.");
    ImGui::End();
    ImGui::Render();
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window);
}

/// Milliseconds from starting this program anew with some arguments to its end.
double millisecondsOf(std::vector<std::string> arguments) {
    std::string self = "/proc/self/exe";
    std::vector<char*> raw{self.data()};
    for (auto& argument : arguments) {
        raw.push_back(argument.data());
    }
    raw.push_back(nullptr);
    const auto begin = std::chrono::steady_clock::now();
    const auto child = fork();
    if (child == 0) {
        execv(self.c_str(), raw.data());
        std::_Exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0) {
        std::fprintf(stderr, "startup_bench: %s did not start\n", arguments.front().c_str());
        std::exit(1);
    }
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
        .count();
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

void measure() {
    std::vector<double> editor, curves, bare;
    for (int round = 0; round < rounds; ++round) {
        bare.push_back(millisecondsOf({"bare"}));
        editor.push_back(millisecondsOf({"editor"}));
        curves.push_back(millisecondsOf({"curves"}));
    }
    std::printf("to the first frame, median of %d: bare %.0f ms, editor %.0f ms, ratio %.2f "
                "(goal: 1.15); with the curves %.0f ms\n",
                rounds, median(bare), median(editor), median(editor) / median(bare),
                median(curves));
}

} // namespace
} // namespace splineloft::app

/// Takes the place of GLFW's own (see CMakeLists.txt): whoever has shown its frames is done once
/// the last is drawn, and ends without tidying up, which is no part of starting.
extern "C" void __wrap_glfwSwapBuffers(GLFWwindow* window) {
    __real_glfwSwapBuffers(window);
    if (--splineloft::app::framesToShow == 0) {
        glFinish();
        std::_Exit(0);
    }
}

int main(int count, char** arguments) {
    const std::vector<std::string> given(arguments + 1, arguments + count);
    if (given.empty()) {
        splineloft::app::measure();
    } else if (given.front() == "bare") {
        splineloft::app::runBareToFirstFrame();
    } else {
        splineloft::app::framesToShow = given.front() == "curves" ? 2 : 1;
        splineloft::app::runEditorToFirstFrame({given.begin() + 1, given.end()});
    }
}
