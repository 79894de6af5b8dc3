/// What the pictures of the global modes show beside them: the local theory and known outcomes,
/// which modes/global does not know.
#pragma once

#include "app/case.hpp"
#include "modes/global/study/map_report.hpp"
#include "modes/global/study/neutral_report.hpp"

namespace pennon::app {

/// Beside a neutral curve: mu_cr by the local theory for each added mass, where it knows the
/// parameter, and the outcomes of lsa.marks. Throws InputError (the table of outcomes).
modes::global::NeutralPicture neutral_picture(const Case&, const modes::global::NeutralCurve&);

/// Beside a map of growth rates: the outcomes of lsa.marks. Throws as above.
modes::global::MapPicture map_picture(const Case&);

}  // namespace pennon::app
