//! CMSIS-SVD.

