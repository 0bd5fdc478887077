#ifndef MJFORGE_REPORT_ASKED_H_
#define MJFORGE_REPORT_ASKED_H_

#include "mjforge/forge/forge.h"
#include "mjforge/report/gather.h"
#include "mjforge/report/tallies.h"

namespace mjforge::report {

/// What the spec asks for, by drawing its parameters afresh: right for every distribution,
/// with ranges that depend on other parameters and with requirements. The indices are the
/// batch's, spread evenly; the seeds are others. Draws that fail count for nothing.
ParameterTallies Ask(const forge::Recipe& recipe, const Gathered& gathered);

}  // namespace mjforge::report

#endif  // MJFORGE_REPORT_ASKED_H_
