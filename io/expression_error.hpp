#pragma once

#include <muParser.h>

#include <string>

#include "io/input_text.hpp"
#include "io/number_text.hpp"

namespace cracksim::io {

/// Explains a parser error to a user who does not know muParser; characters count from 1.
[[nodiscard]] inline std::string explanation(const mu::ParserError& error) {
    const std::string& found = error.GetToken();
    const std::string token = "'" + shortened(found.substr(0, found.find_last_not_of(" \n") + 1)) + "'";
    const std::string place = " at character " + std::to_string(error.GetPos() + 1);
    switch (error.GetCode()) {
        case mu::ecUNASSIGNABLE_TOKEN:
            return token + place +
                   (names_infinity(found) || found.starts_with(".inf") ? ": infinity has no place in a formula"
                    : is_beyond_range(found)                           ? " is too large; numbers reach up to 1.7e308"
                                                                       : " is not known");
        case mu::ecUNEXPECTED_OPERATOR:
        case mu::ecUNEXPECTED_ARG_SEP:
        case mu::ecUNEXPECTED_ARG:
        case mu::ecUNEXPECTED_VAL:
        case mu::ecUNEXPECTED_VAR:
        case mu::ecUNEXPECTED_PARENS:
        case mu::ecUNEXPECTED_FUN:
        case mu::ecUNEXPECTED_CONDITIONAL: return token + place + " is out of place";
        case mu::ecUNEXPECTED_EOF: return "it ends too early";
        case mu::ecMISSING_PARENS: return "a bracket is not closed";
        case mu::ecTOO_MANY_PARAMS: return "a function has too many arguments" + place;
        case mu::ecTOO_FEW_PARAMS: return "a function has too few arguments" + place;
        case mu::ecEMPTY_EXPRESSION: return "it is empty";
        case mu::ecMISSING_ELSE_CLAUSE: return "'?' without ':'";
        case mu::ecMISPLACED_COLON: return "':' without '?'";
        case mu::ecEXPRESSION_TOO_LONG:
            return "it has more than " + std::to_string(mu::MaxLenExpression) + " characters";
        case mu::ecIDENTIFIER_TOO_LONG:
            return "a name has more than " + std::to_string(mu::MaxLenIdentifier) + " characters";
        default: return shortened(error.GetMsg());
    }
}

}  // namespace cracksim::io
