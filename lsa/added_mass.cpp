#include "lsa/added_mass.hpp"

namespace pennon::lsa {

double added_mass(AddedMass kind, const MinamiSettings& settings, double k_x, double k_y) {
  switch (kind) {
    case AddedMass::two_d:
      return closed_form_added_mass<AddedMass::two_d>(k_x, k_y);
    case AddedMass::wu:
      return closed_form_added_mass<AddedMass::wu>(k_x, k_y);
    case AddedMass::lamb:
      return closed_form_added_mass<AddedMass::lamb>(k_x, k_y);
    case AddedMass::minami:
      break;
  }
  return minami(settings, k_x, k_y);
}

}  // namespace pennon::lsa
