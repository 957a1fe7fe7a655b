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
    ImGui_ImplOpenGL3_DestroyDeviceObjects();
#endif
    ImGui_ImplOpenGL3_NewFrame(); // makes what is missing, the texture of the fonts with it
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
