//! Microchip dsPIC33F/PIC24H ECAN, chapter by chapter of its manual.
