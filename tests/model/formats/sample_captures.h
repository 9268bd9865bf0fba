// Small captures of the packets of LiDARs, and recordings of them.
#pragma once

#include "tests/model/formats/sample_files.h"

namespace remount::formats::samples {

Bytes captured_velodyne();
Bytes captured_pcapng();  ///< the same
Bytes captured_livox();
Bytes captured_former_livox();  ///< of the first SDK
Bytes captured_helios();
Bytes captured_rs16();
Bytes captured_m1();
Bytes recorded_lvx(int minor);  ///< of version 1; of 2 where it is negative

}  // namespace remount::formats::samples
