// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared/prepared_design.h"

namespace latticast {

PreparedDesign::PreparedDesign(const Design& from)
    : design(from)
#if LATTICAST_HAS_GEOMETRY
      ,
      lattices(from)
#endif
#if LATTICAST_HAS_MOLDS
      ,
      molds(from, lattices)
#endif
#if LATTICAST_HAS_PREDICT
      ,
      responses(from)
#endif
{
}

}  // namespace latticast
