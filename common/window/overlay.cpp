#include "common/window/overlay.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>
#include <imgui_internal.h>  // its queue of input, and which field is typed into

#include <filesystem>
#include <iterator>

#include "common/base/error.h"
#include "common/window/display.h"
#include "common/window/event_log.h"

namespace lightwalk {
namespace {

// Greek letters, arrows and mathematics occur in the help of knobs.
constexpr ImWchar glyphs[] = {0x20,   0xff,   0x0391, 0x03c9, 0x2010, 0x2026, 0x2070,
                              0x209f, 0x2190, 0x21d4, 0x2200, 0x226f, 0};

// The first font of the list that is installed; Dear ImGui's own small bitmap font where none is.
ImFont* load_font(std::initializer_list<const char*> files, float pixels) {
    std::error_code ignored;
    for (const char* file : files)
        if (std::filesystem::exists(file, ignored))
            if (ImFont* font = ImGui::GetIO().Fonts->AddFontFromFileTTF(file, pixels, nullptr, glyphs)) return font;
    ImFontConfig config;
    config.SizePixels = 13.0f * std::max(1.0f, std::floor(pixels / 13.0f));
    return ImGui::GetIO().Fonts->AddFontDefault(&config);
}

constexpr const char* icon_file = "/usr/share/fonts/truetype/font-awesome/fontawesome-webfont.ttf";
constexpr ImWchar icon_glyphs[] = {0xf000, 0xf2e0, 0};
bool icons_are_there = false;

// Into the font loaded last.
void add_icons(float pixels) {
    std::error_code ignored;
    if (!std::filesystem::exists(icon_file, ignored)) return;
    ImFontConfig config;
    config.MergeMode = true;
    config.GlyphMinAdvanceX = config.GlyphMaxAdvanceX = pixels * 1.2f;  // all as wide, so that names stand in a column
    icons_are_there = ImGui::GetIO().Fonts->AddFontFromFileTTF(icon_file, pixels, &config, icon_glyphs);
}

ImFont* sans(float pixels) {
    return load_font(
        {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
         "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"},
        pixels);
}

void set_style(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = style.FrameRounding = style.GrabRounding = style.PopupRounding = 3.0f;
    style.WindowBorderSize = style.FrameBorderSize = 0.0f;
    style.WindowPadding = {12.0f, 10.0f};
    style.FramePadding = {8.0f, 3.0f};
    style.ItemSpacing = {8.0f, 5.0f};
    style.ScrollbarSize = 10.0f;
    style.ScaleAllSizes(scale);
    const ImVec4 ground{0.085f, 0.095f, 0.115f, 1.0f}, raised{0.15f, 0.165f, 0.195f, 1.0f};
    const ImVec4 accent{0.24f, 0.47f, 0.70f, 1.0f}, bright{0.33f, 0.60f, 0.87f, 1.0f};
    const auto set = [&](std::initializer_list<ImGuiCol> which, const ImVec4& color) {
        for (const ImGuiCol index : which) style.Colors[index] = color;
    };
    set({ImGuiCol_WindowBg}, ground);
    set({ImGuiCol_PopupBg}, {0.11f, 0.12f, 0.145f, 0.98f});
    set({ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Header}, raised);
    set({ImGuiCol_FrameBgHovered, ImGuiCol_ButtonHovered, ImGuiCol_HeaderHovered}, {0.20f, 0.225f, 0.27f, 1.0f});
    set({ImGuiCol_FrameBgActive, ImGuiCol_ButtonActive, ImGuiCol_HeaderActive}, accent);
    set({ImGuiCol_SliderGrab, ImGuiCol_PlotHistogram}, accent);
    set({ImGuiCol_SliderGrabActive, ImGuiCol_CheckMark}, bright);
    set({ImGuiCol_Text}, {0.90f, 0.92f, 0.95f, 1.0f});
    set({ImGuiCol_TextDisabled}, quiet_color);
    set({ImGuiCol_Separator}, {0.20f, 0.22f, 0.26f, 1.0f});
    set({ImGuiCol_ScrollbarBg}, {0.0f, 0.0f, 0.0f, 0.0f});
    set({ImGuiCol_ModalWindowDimBg}, {0.0f, 0.0f, 0.0f, 0.5f});
}

void check_imgui(VkResult result) { check(result, "the panel"); }

// Dear ImGui's Vulkan backend; its interface changed in 1.90, 1.90.3 and 1.92.4. One sample a pixel.
void start_imgui(ImGui_ImplVulkan_InitInfo& info, VkRenderPass render_pass, [[maybe_unused]] Gpu& gpu) {
#if IMGUI_VERSION_NUM >= 19240
    info.PipelineInfoMain.RenderPass = render_pass;
    ImGui_ImplVulkan_Init(&info);
#elif IMGUI_VERSION_NUM >= 19030
    info.RenderPass = render_pass;
    ImGui_ImplVulkan_Init(&info);
#else
    ImGui_ImplVulkan_Init(&info, render_pass);
#endif
#if IMGUI_VERSION_NUM < 19000  // later ones upload their fonts by themselves, with the first frame
    gpu.submit_now([](VkCommandBuffer commands) { ImGui_ImplVulkan_CreateFontsTexture(commands); });
    ImGui_ImplVulkan_DestroyFontUploadObjects();
#endif
}

[[maybe_unused]] GLFWcursorenterfun imgui_cursor_enter = nullptr;

// From 1.87 on ImGui takes a mouse that comes back to be where it last saw it, outside too, until GLFW says that it has
// moved; and GLFW says nothing if it came back to the pixel that it left.
void watch_entering(GLFWwindow* window) {
#if IMGUI_VERSION_NUM >= 18700
    imgui_cursor_enter = glfwSetCursorEnterCallback(window, [](GLFWwindow* entered, int is_inside) {
        imgui_cursor_enter(entered, is_inside);
        double x = 0, y = 0;
        glfwGetCursorPos(entered, &x, &y);
        if (is_inside) ImGui::GetIO().AddMousePosEvent(static_cast<float>(x), static_cast<float>(y));
    });
#else
    (void)window;
#endif
}

}  // namespace

Overlay::Overlay(Gpu& gpu, Display& display, Swapchain& swapchain) : gpu_(gpu), swapchain_(swapchain) {
    make_render_pass();
    // Dear ImGui up to 1.92.7 binds the first kind, later ones the other two.
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 8},
                                          {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, 8},
                                          {VK_DESCRIPTOR_TYPE_SAMPLER, 8}};
    const VkDescriptorPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                          .flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT,
                                          .maxSets = 24,
                                          .poolSizeCount = std::size(sizes),
                                          .pPoolSizes = sizes};
    check(vkCreateDescriptorPool(gpu.device.handle, &pool, nullptr, &descriptors_), "vkCreateDescriptorPool");
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // nothing is left behind in the current folder
    const float scale = display.scale();
    set_style(scale);
    ImGui::GetIO().FontDefault = sans(15.0f * scale);
    add_icons(14.0f * scale);
    mono = load_font({"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
                      "/usr/share/fonts/truetype/liberation/LiberationMono-Regular.ttf"},
                     14.0f * scale);
    large = sans(20.0f * scale);
    ImGui_ImplGlfw_InitForVulkan(display.window, true);
    watch_entering(display.window);
    hold_short_keys(display.window);
    ImGui_ImplVulkan_InitInfo info{};
    info.Instance = gpu.device.instance;
    info.PhysicalDevice = gpu.device.physical;
    info.Device = gpu.device.handle;
    info.QueueFamily = gpu.device.queue_family;
    info.Queue = gpu.device.queue;
    info.DescriptorPool = descriptors_;
    info.MinImageCount = 2;
    info.ImageCount = 2;
    info.CheckVkResultFn = check_imgui;
    start_imgui(info, render_pass_, gpu);
}

Overlay::~Overlay() {
    vkDeviceWaitIdle(gpu_.device.handle);
    ImGui_ImplVulkan_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    for (const VkFramebuffer framebuffer : framebuffers_)
        vkDestroyFramebuffer(gpu_.device.handle, framebuffer, nullptr);
    vkDestroyDescriptorPool(gpu_.device.handle, descriptors_, nullptr);
    vkDestroyRenderPass(gpu_.device.handle, render_pass_, nullptr);
}

// The one render pass object of the course: this version of Dear ImGui does not know dynamic rendering.
void Overlay::make_render_pass() {
    const VkAttachmentDescription color{.format = swapchain_.format,
                                        .samples = VK_SAMPLE_COUNT_1_BIT,
                                        .loadOp = VK_ATTACHMENT_LOAD_OP_LOAD,
                                        .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                                        .stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                                        .stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE,
                                        .initialLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                        .finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR};
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    const VkSubpassDescription subpass{.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS,
                                       .colorAttachmentCount = 1,
                                       .pColorAttachments = &reference};
    const VkSubpassDependency dependencies[] = {
        {.srcSubpass = VK_SUBPASS_EXTERNAL,
         .srcStageMask = VK_PIPELINE_STAGE_TRANSFER_BIT,
         .dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
         .srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT,
         .dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT},
        {.dstSubpass = VK_SUBPASS_EXTERNAL,
         .srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
         .dstStageMask = VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT,
         .srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT}};
    const VkRenderPassCreateInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
                                      .attachmentCount = 1,
                                      .pAttachments = &color,
                                      .subpassCount = 1,
                                      .pSubpasses = &subpass,
                                      .dependencyCount = 2,
                                      .pDependencies = dependencies};
    check(vkCreateRenderPass(gpu_.device.handle, &info, nullptr, &render_pass_), "vkCreateRenderPass");
}

void Overlay::make_framebuffers() {
    if (generation_ == swapchain_.generation()) return;
    generation_ = swapchain_.generation();
    for (const VkFramebuffer framebuffer : framebuffers_)
        vkDestroyFramebuffer(gpu_.device.handle, framebuffer, nullptr);
    framebuffers_.clear();
    for (const VkImageView& view : swapchain_.views) {
        const VkFramebufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                           .renderPass = render_pass_,
                                           .attachmentCount = 1,
                                           .pAttachments = &view,
                                           .width = swapchain_.size.x,
                                           .height = swapchain_.size.y,
                                           .layers = 1};
        check(vkCreateFramebuffer(gpu_.device.handle, &info, nullptr, &framebuffers_.emplace_back()), "framebuffer");
    }
}

ImGuiID number_typed_into() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    return context.ActiveId == context.TempInputId ? context.ActiveId : 0;
}

bool close_popup() {
    const ImVector<ImGuiPopupData>& open = ImGui::GetCurrentContext()->OpenPopupStack;
    if (open.empty() || !open.back().Window || (open.back().Window->Flags & ImGuiWindowFlags_Modal)) return false;
    ImGui::ClosePopupToLevel(open.Size - 1, true);
    return true;
}

void enable_keyboard() { ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard; }

bool keyboard_marks() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
#if IMGUI_VERSION_NUM >= 19140
    return context.NavId != 0 && context.NavCursorVisible;
#else
    return context.NavId != 0 && !context.NavDisableHighlight;
#endif
}

void leave_keyboard() { ImGui::SetWindowFocus(nullptr); }

void stop_dragging() { ImGui::ClearActiveID(); }

bool has_icons() { return icons_are_there; }

bool Overlay::input_is_left() const { return short_keys_wait(); }

void Overlay::begin() {
    ImGui_ImplVulkan_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    pass_short_keys();
    ImGui::NewFrame();
    note_keys_were_read();
    log_mouse();
}

void Overlay::end() { ImGui::Render(); }

void Overlay::draw(VkCommandBuffer commands) {
    make_framebuffers();
    const VkRenderPassBeginInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                     .renderPass = render_pass_,
                                     .framebuffer = framebuffers_.at(swapchain_.index()),
                                     .renderArea = {.extent = {swapchain_.size.x, swapchain_.size.y}}};
    vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
    vkCmdEndRenderPass(commands);
}

}  // namespace lightwalk
