#include "app/imgui_versions.h"

#include "app/window.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace splineloft::app {

namespace {

const char* paste(Clipboard& clipboard) {
    clipboard.text = clipboard.window.clipboard();
    return clipboard.text.c_str();
}

void copy(Clipboard& clipboard, const char* text) {
    clipboard.window.setClipboard(text);
}

} // namespace

void renewFontTexture() {
#if IMGUI_VERSION_NUM < 19200 // from then on Dear ImGui keeps its textures up to date by itself
    // Only the texture: 1.86 forgets how small its buffers are when it makes them anew, and draws
    // nothing from then on.
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_NewFrame(); // makes everything else, the first time with a texture
    if (!ImGui::GetIO().Fonts->TexID) {
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
#else
    ImGui_ImplOpenGL3_NewFrame();
#endif
}

void shareClipboard(Clipboard& clipboard) {
#if IMGUI_VERSION_NUM >= 19110
    auto& platform = ImGui::GetPlatformIO();
    platform.Platform_ClipboardUserData = &clipboard;
    platform.Platform_GetClipboardTextFn = [](ImGuiContext*) {
        return paste(*static_cast<Clipboard*>(ImGui::GetPlatformIO().Platform_ClipboardUserData));
    };
    platform.Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) {
        copy(*static_cast<Clipboard*>(ImGui::GetPlatformIO().Platform_ClipboardUserData), text);
    };
#else
    auto& io = ImGui::GetIO();
    io.ClipboardUserData = &clipboard;
    io.GetClipboardTextFn = [](void* user) { return paste(*static_cast<Clipboard*>(user)); };
    io.SetClipboardTextFn = [](void* user, const char* text) {
        copy(*static_cast<Clipboard*>(user), text);
    };
#endif
}

} // namespace splineloft::app
