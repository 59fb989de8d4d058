// SPDX-License-Identifier: MIT
#include "pipeline/emit/gs_text.h"

namespace pipeline {

namespace {

std::string hexadecimal(std::uint64_t value, std::size_t digits) {
    std::string text(digits, '0');
    for (std::size_t i = digits; i-- > 0; value >>= 4) text[i] = "0123456789abcdef"[value & 15];
    return text;
}

std::string address_text(GsReg reg) {
    const auto address = static_cast<std::uint32_t>(reg);
    return hexadecimal(address, address < 0x100 ? 2 : 8);
}

}  // namespace

std::string gs_text(const GsWrite& write) {
    std::string text      = address_text(write.reg) + ' ';
    const GsRegister* reg = find_gs_register(static_cast<std::uint32_t>(write.reg));
    if (reg != nullptr) text += std::string(reg->name) + ' ';
    text += hexadecimal(write.value, 16);
    if (reg == nullptr) return text;
    std::string_view between = ": ";
    for (const GsField& field : reg->fields) {
        text += std::string(between) + field_text(field, write.value);
        between = ", ";
    }
    if (reg->fields.empty()) text += ": " + std::string(reg->meaning);
    return text;
}

std::string gs_text(const GsStream& stream) {
    std::string text =
        "// Graphics Synthesizer: address, register, value: its fields. Registers are written in this order, by A+D.\n"
        "// X and Y hold 2048 pixels more than the window's; 1.0 of colours is 0x80; addresses are bytes of local memory.\n";
    for (const GsGroup& group : stream.groups) {
        text += "\n// == " + group.label + '\n';
        for (const GsStep& step : group.steps) {
            text += "// " + step.what + '\n';
            for (const GsWrite& write : step.writes) text += gs_text(write) + '\n';
            if (!step.image.empty()) text += "54 HWREG " + std::to_string(step.image.size()) + " bytes\n";
        }
    }
    text += "\n// == shown by, written by the CPU\n";
    for (const GsWrite& write : stream.display) text += gs_text(write) + '\n';
    return text;
}

}  // namespace pipeline
