/* PIC32MX Controller Area Network (CAN): registers and message layouts.
 * CAN 2.0B controller of the Microchip PIC32MX family, up to 1 Mbit/s. It has 32 message FIFOs, each of which is
 * either a transmit or a receive FIFO of 1 to 32 messages, 32 acceptance filters and 4 masks. The messages
 * themselves lie in system RAM: the module is a bus master that fetches and stores them at physical addresses
 * without CPU or DMA.
 * Described after PIC32MX Family Reference Manual, Section 34. Controller Area Network (CAN), Microchip
 * Technology Inc., revision A.
 * Generated from the description of the controller; changes belong there.
 * C99 or C++11. A field FIELD of a register REG has PIC32_CAN_REG_FIELD_Pos, _Msk, _Width and _Access; a field
 * that is repeated in its register takes the number of the lane, counted from 0, as an argument.
 * Access codes: rw, ro, wo; w1c and w0c are flags cleared by writing 1 or 0; w1s is a request made by writing 1;
 * rwhc a request that 0 withdraws; rwh is changed by hardware too; wclr is cleared or preset by any write; +rc
 * and +rs are cleared or set by a read, @n of byte n; a condition for writing stands behind the colon.
 * Define PIC32_CAN_ASSERT(condition) to have ranges and indices checked at run time.
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef PIC32_CAN_H
#define PIC32_CAN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__cplusplus)
#define PIC32_CAN_STATIC_ASSERT(condition, name) static_assert(condition, #name)
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define PIC32_CAN_STATIC_ASSERT(condition, name) _Static_assert(condition, #name)
#else
#define PIC32_CAN_STATIC_ASSERT(condition, name) typedef char name[(condition) ? 1 : -1]
#endif

#ifndef PIC32_CAN_ASSERT
#define PIC32_CAN_ASSERT(condition) ((void)0)
#endif

/* A register that software can only read. C++ wants every const member initialized. */
#ifdef __cplusplus
#define PIC32_CAN_READ_ONLY volatile
#else
#define PIC32_CAN_READ_ONLY volatile const
#endif

/* Values of CON.REQOP, CON.OPMOD.
 * Operating modes of the module.
 * Register 34-1 p.14; §34.5 p.53
 */
/* Takes part in the bus traffic, sends and receives. */
#define PIC32_CAN_OPERATION_MODE_NORMAL 0U
/* Internal clock stopped as soon as no message is in progress, CiTX recessive. Error counters keep their values. */
#define PIC32_CAN_OPERATION_MODE_DISABLE 1U
/* Transmit path fed back to the receive path inside the module with a dummy acknowledge; nothing reaches the
 * bus.
 */
#define PIC32_CAN_OPERATION_MODE_LOOPBACK 2U
/* Receives only: no transmission, no error flags, no acknowledge, error counters not in use. */
#define PIC32_CAN_OPERATION_MODE_LISTEN_ONLY 3U
/* The mode after reset and the only one in which the protected registers can be written. Entering it resets all
 * FIFOs.
 */
#define PIC32_CAN_OPERATION_MODE_CONFIGURATION 4U
/* Like normal mode, but a message received with an error is stored too, with the data received up to the error,
 * if a filter accepts it.
 */
#define PIC32_CAN_OPERATION_MODE_LISTEN_ALL 7U

/* Values of VEC.ICOD.
 * The pending enabled interrupt of the highest natural priority. A higher code has the higher priority, except
 * that no_interrupt is the idle value and not a priority.
 * Register 34-4 p.21; §34.12.6
 */
/* FIFO n, that is, bit n of CiFSTAT is set. */
#define PIC32_CAN_INTERRUPT_CODE_FIFO_FIRST 0U
#define PIC32_CAN_INTERRUPT_CODE_FIFO_LAST 31U
/* Nothing is pending. */
#define PIC32_CAN_INTERRUPT_CODE_NO_INTERRUPT 64U
/* CERRIF. */
#define PIC32_CAN_INTERRUPT_CODE_ERROR 65U
/* WAKIF. */
#define PIC32_CAN_INTERRUPT_CODE_WAKE_UP 66U
/* RBOVIF. */
#define PIC32_CAN_INTERRUPT_CODE_RECEIVE_OVERFLOW 67U
/* SERRIF, because a FIFO or a message lies at an address the module cannot use. */
#define PIC32_CAN_INTERRUPT_CODE_ADDRESS_ERROR 68U
/* SERRIF, because a received message could not be stored before the next one arrived. */
#define PIC32_CAN_INTERRUPT_CODE_BUS_BANDWIDTH_ERROR 69U
/* CTMRIF. */
#define PIC32_CAN_INTERRUPT_CODE_TIME_STAMP_TIMER 70U
/* MODIF. */
#define PIC32_CAN_INTERRUPT_CODE_MODE_CHANGE 71U
/* IVRIF. */
#define PIC32_CAN_INTERRUPT_CODE_INVALID_MESSAGE 72U

/* Type of the identifier of a message.
 * Figure 34-12 p.63
 */
/* 11-bit identifier. */
#define PIC32_CAN_IDENTIFIER_TYPE_STANDARD 0U
/* 29-bit identifier. */
#define PIC32_CAN_IDENTIFIER_TYPE_EXTENDED 1U

/* Whether a message carries data or asks for it.
 * Figure 34-12 p.63
 */
/* Not a remote transmission request. */
#define PIC32_CAN_FRAME_TYPE_DATA_FRAME 0U
/* Remote transmission request. */
#define PIC32_CAN_FRAME_TYPE_REMOTE_FRAME 1U

/* Data length code of a message.
 * Figure 34-12 p.63
 */
#define PIC32_CAN_DATA_LENGTH_BYTES_0 0U
#define PIC32_CAN_DATA_LENGTH_BYTES_1 1U
#define PIC32_CAN_DATA_LENGTH_BYTES_2 2U
#define PIC32_CAN_DATA_LENGTH_BYTES_3 3U
#define PIC32_CAN_DATA_LENGTH_BYTES_4 4U
#define PIC32_CAN_DATA_LENGTH_BYTES_5 5U
#define PIC32_CAN_DATA_LENGTH_BYTES_6 6U
#define PIC32_CAN_DATA_LENGTH_BYTES_7 7U
/* Eight data bytes whatever the three lower bits. */
#define PIC32_CAN_DATA_LENGTH_BYTES_8_FIRST 8U
#define PIC32_CAN_DATA_LENGTH_BYTES_8_LAST 15U

/* Values of CON.DNCNT.
 * Register 34-1 p.14; Table 34-1 p.11 (offset)
 */
/* DeviceNet filtering is off. */
#define PIC32_CAN_CON_DNCNT_NO_COMPARISON 0U
/* The first n data bits are compared, beginning with bit 7 of data byte 0. */
#define PIC32_CAN_CON_DNCNT_DATA_BITS_FIRST 1U
#define PIC32_CAN_CON_DNCNT_DATA_BITS_LAST 18U

/* Values of CFG.SEG2PHTS.
 * Register 34-2 p.16; Table 34-1 p.11 (offset)
 */
/* Segment 2 is as long as segment 1 or the information processing time, whichever is longer. */
#define PIC32_CAN_CFG_SEG2PHTS_AUTOMATIC 0U
/* Segment 2 has the length given in SEG2PH. */
#define PIC32_CAN_CFG_SEG2PHTS_PROGRAMMABLE 1U

/* Values of CFG.SAM.
 * Register 34-2 p.16; Table 34-1 p.11 (offset)
 */
/* The bus is sampled once. */
#define PIC32_CAN_CFG_SAM_ONCE 0U
/* The bus is sampled three times and the majority decides. Not allowed with BRP below 2. */
#define PIC32_CAN_CFG_SAM_THREE_TIMES 1U

/* Values of VEC.FILHIT.
 * Register 34-4 p.20; Table 34-1 p.11 (offset)
 */
/* Filter n. */
#define PIC32_CAN_VEC_FILHIT_FILTER_FIRST 0U
#define PIC32_CAN_VEC_FILHIT_FILTER_LAST 31U

/* Values of RXM.MIDE.
 * Register 34-9 p.26; §34.8.3 p.75; Table 34-1 p.11 (offset)
 */
/* Standard messages match on SID, extended ones on SID and EID, whatever EXID says. */
#define PIC32_CAN_RXM_MIDE_ANY_TYPE 0U
/* Only messages of the type that EXID of the filter asks for match. */
#define PIC32_CAN_RXM_MIDE_TYPE_OF_FILTER 1U

/* Values of FLTCON.MSEL.
 * Register 34-10 p.27; Table 34-1 p.12 (offset)
 */
/* Acceptance mask n. */
#define PIC32_CAN_FLT_CON_MSEL_MASK_FIRST 0U
#define PIC32_CAN_FLT_CON_MSEL_MASK_LAST 3U

/* Values of FLTCON.FSEL.
 * Register 34-10 p.27; Table 34-1 p.12 (offset)
 */
/* FIFO n. */
#define PIC32_CAN_FLT_CON_FSEL_FIFO_FIRST 0U
#define PIC32_CAN_FLT_CON_FSEL_FIFO_LAST 31U

/* Values of RXF.EXID.
 * Register 34-18 p.43; Table 34-1 p.12 (offset); Table 34-1 p.12 (stride); external: device_addresses (stride)
 */
/* Matches messages with a standard identifier. */
#define PIC32_CAN_RXF_EXID_STANDARD 0U
/* Matches messages with an extended identifier. */
#define PIC32_CAN_RXF_EXID_EXTENDED 1U

/* Values of FIFOCON.DONLY.
 * Register 34-20 p.45; Table 34-1 p.12 (offset)
 */
/* Identifier, length, filter, time stamp and data are stored, 16 bytes a message. */
#define PIC32_CAN_FIFO_CON_DONLY_FULL_MESSAGE 0U
/* Only the data bytes are stored, 8 bytes a message. */
#define PIC32_CAN_FIFO_CON_DONLY_DATA_ONLY 1U

/* Values of FIFOCON.TXEN.
 * Register 34-20 p.45; Table 34-1 p.12 (offset)
 */
/* Receive FIFO. */
#define PIC32_CAN_FIFO_CON_TXEN_RECEIVE 0U
/* Transmit FIFO. */
#define PIC32_CAN_FIFO_CON_TXEN_TRANSMIT 1U

/* Values of FIFOCON.TXPRI.
 * Register 34-20 p.45; Table 34-1 p.12 (offset)
 */
#define PIC32_CAN_FIFO_CON_TXPRI_LOWEST 0U
#define PIC32_CAN_FIFO_CON_TXPRI_LOW_INTERMEDIATE 1U
#define PIC32_CAN_FIFO_CON_TXPRI_HIGH_INTERMEDIATE 2U
#define PIC32_CAN_FIFO_CON_TXPRI_HIGHEST 3U

/* Table 34-5 p.80; §34.9 p.80; Example 34-13 p.83 */
/* Filter n. */
#define PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_FILTER_FIRST 0U
#define PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_FILTER_LAST 31U

/* Message FIFO. */
typedef struct {
    volatile uint32_t FIFOCON; /* CAN FIFO Control Register */
    volatile uint32_t FIFOCONCLR;
    volatile uint32_t FIFOCONSET;
    volatile uint32_t FIFOCONINV;
    volatile uint32_t FIFOINT; /* CAN FIFO Interrupt Register */
    volatile uint32_t FIFOINTCLR;
    volatile uint32_t FIFOINTSET;
    volatile uint32_t FIFOINTINV;
    PIC32_CAN_READ_ONLY uint32_t FIFOUA; /* CAN FIFO User Address Register */
    volatile uint32_t FIFOUACLR;
    volatile uint32_t FIFOUASET;
    volatile uint32_t FIFOUAINV;
    PIC32_CAN_READ_ONLY uint32_t FIFOCI; /* CAN Module Message Index Register */
    volatile uint32_t FIFOCICLR;
    volatile uint32_t FIFOCISET;
    volatile uint32_t FIFOCIINV;
} pic32_can_fifo_t;

/* The register block. */
typedef struct pic32_can_regs {
    volatile uint32_t CON; /* CAN Control Register */
    volatile uint32_t CONCLR;
    volatile uint32_t CONSET;
    volatile uint32_t CONINV;
    volatile uint32_t CFG; /* CAN Baud Rate Configuration Register */
    volatile uint32_t CFGCLR;
    volatile uint32_t CFGSET;
    volatile uint32_t CFGINV;
    volatile uint32_t INT; /* CAN Interrupt Register */
    volatile uint32_t INTCLR;
    volatile uint32_t INTSET;
    volatile uint32_t INTINV;
    PIC32_CAN_READ_ONLY uint32_t VEC; /* CAN Interrupt Code Register */
    volatile uint32_t VECCLR;
    volatile uint32_t VECSET;
    volatile uint32_t VECINV;
    PIC32_CAN_READ_ONLY uint32_t TREC; /* CAN Transmit/Receive Error Count Register */
    volatile uint32_t TRECCLR;
    volatile uint32_t TRECSET;
    volatile uint32_t TRECINV;
    PIC32_CAN_READ_ONLY uint32_t FSTAT; /* CAN FIFO Status Register */
    volatile uint32_t FSTATCLR;
    volatile uint32_t FSTATSET;
    volatile uint32_t FSTATINV;
    PIC32_CAN_READ_ONLY uint32_t RXOVF; /* CAN Receive FIFO Overflow Status Register */
    volatile uint32_t RXOVFCLR;
    volatile uint32_t RXOVFSET;
    volatile uint32_t RXOVFINV;
    volatile uint32_t TMR; /* CAN Timer Register */
    volatile uint32_t TMRCLR;
    volatile uint32_t TMRSET;
    volatile uint32_t TMRINV;
    struct {
        volatile uint32_t RXM; /* CAN Acceptance Filter Mask Register */
        volatile uint32_t RXMCLR;
        volatile uint32_t RXMSET;
        volatile uint32_t RXMINV;
    } RXM[4];
    struct {
        volatile uint32_t FLTCON; /* CAN Filter Control Register */
        volatile uint32_t FLTCONCLR;
        volatile uint32_t FLTCONSET;
        volatile uint32_t FLTCONINV;
    } FLTCON[8];
    struct {
        volatile uint32_t RXF; /* CAN Acceptance Filter Register */
        volatile uint32_t RXFCLR;
        volatile uint32_t RXFSET;
        volatile uint32_t RXFINV;
    } RXF[32];
    volatile uint32_t FIFOBA; /* CAN Message Buffer Base Address Register */
    volatile uint32_t FIFOBACLR;
    volatile uint32_t FIFOBASET;
    volatile uint32_t FIFOBAINV;
    pic32_can_fifo_t FIFO[32];
} pic32_can_regs_t;

PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, CON) == 0x000U, pic32_can_at_CON);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, CONCLR) == 0x004U, pic32_can_at_CONCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, CONSET) == 0x008U, pic32_can_at_CONSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, CONINV) == 0x00CU, pic32_can_at_CONINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, CFG) == 0x010U, pic32_can_at_CFG);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, CFGCLR) == 0x014U, pic32_can_at_CFGCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, CFGSET) == 0x018U, pic32_can_at_CFGSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, CFGINV) == 0x01CU, pic32_can_at_CFGINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, INT) == 0x020U, pic32_can_at_INT);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, INTCLR) == 0x024U, pic32_can_at_INTCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, INTSET) == 0x028U, pic32_can_at_INTSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, INTINV) == 0x02CU, pic32_can_at_INTINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, VEC) == 0x030U, pic32_can_at_VEC);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, VECCLR) == 0x034U, pic32_can_at_VECCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, VECSET) == 0x038U, pic32_can_at_VECSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, VECINV) == 0x03CU, pic32_can_at_VECINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, TREC) == 0x040U, pic32_can_at_TREC);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, TRECCLR) == 0x044U, pic32_can_at_TRECCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, TRECSET) == 0x048U, pic32_can_at_TRECSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, TRECINV) == 0x04CU, pic32_can_at_TRECINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FSTAT) == 0x050U, pic32_can_at_FSTAT);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FSTATCLR) == 0x054U, pic32_can_at_FSTATCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FSTATSET) == 0x058U, pic32_can_at_FSTATSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FSTATINV) == 0x05CU, pic32_can_at_FSTATINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXOVF) == 0x060U, pic32_can_at_RXOVF);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXOVFCLR) == 0x064U, pic32_can_at_RXOVFCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXOVFSET) == 0x068U, pic32_can_at_RXOVFSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXOVFINV) == 0x06CU, pic32_can_at_RXOVFINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, TMR) == 0x070U, pic32_can_at_TMR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, TMRCLR) == 0x074U, pic32_can_at_TMRCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, TMRSET) == 0x078U, pic32_can_at_TMRSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, TMRINV) == 0x07CU, pic32_can_at_TMRINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXM[0].RXM) == 0x080U, pic32_can_at_RXM_0__RXM);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXM[0].RXMCLR) == 0x084U, pic32_can_at_RXM_0__RXMCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXM[0].RXMSET) == 0x088U, pic32_can_at_RXM_0__RXMSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXM[0].RXMINV) == 0x08CU, pic32_can_at_RXM_0__RXMINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXM[1].RXM) == 0x090U, pic32_can_at_RXM_1__RXM);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXM[1].RXMCLR) == 0x094U, pic32_can_at_RXM_1__RXMCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXM[1].RXMSET) == 0x098U, pic32_can_at_RXM_1__RXMSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXM[1].RXMINV) == 0x09CU, pic32_can_at_RXM_1__RXMINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FLTCON[0].FLTCON) == 0x0C0U, pic32_can_at_FLTCON_0__FLTCON);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FLTCON[0].FLTCONCLR) == 0x0C4U, pic32_can_at_FLTCON_0__FLTCONCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FLTCON[0].FLTCONSET) == 0x0C8U, pic32_can_at_FLTCON_0__FLTCONSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FLTCON[0].FLTCONINV) == 0x0CCU, pic32_can_at_FLTCON_0__FLTCONINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FLTCON[1].FLTCON) == 0x0D0U, pic32_can_at_FLTCON_1__FLTCON);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FLTCON[1].FLTCONCLR) == 0x0D4U, pic32_can_at_FLTCON_1__FLTCONCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FLTCON[1].FLTCONSET) == 0x0D8U, pic32_can_at_FLTCON_1__FLTCONSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FLTCON[1].FLTCONINV) == 0x0DCU, pic32_can_at_FLTCON_1__FLTCONINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXF[0].RXF) == 0x140U, pic32_can_at_RXF_0__RXF);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXF[0].RXFCLR) == 0x144U, pic32_can_at_RXF_0__RXFCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXF[0].RXFSET) == 0x148U, pic32_can_at_RXF_0__RXFSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXF[0].RXFINV) == 0x14CU, pic32_can_at_RXF_0__RXFINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXF[1].RXF) == 0x150U, pic32_can_at_RXF_1__RXF);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXF[1].RXFCLR) == 0x154U, pic32_can_at_RXF_1__RXFCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXF[1].RXFSET) == 0x158U, pic32_can_at_RXF_1__RXFSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, RXF[1].RXFINV) == 0x15CU, pic32_can_at_RXF_1__RXFINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFOBA) == 0x340U, pic32_can_at_FIFOBA);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFOBACLR) == 0x344U, pic32_can_at_FIFOBACLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFOBASET) == 0x348U, pic32_can_at_FIFOBASET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFOBAINV) == 0x34CU, pic32_can_at_FIFOBAINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOCON) == 0x350U, pic32_can_at_FIFO_0__FIFOCON);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOCONCLR) == 0x354U, pic32_can_at_FIFO_0__FIFOCONCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOCONSET) == 0x358U, pic32_can_at_FIFO_0__FIFOCONSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOCONINV) == 0x35CU, pic32_can_at_FIFO_0__FIFOCONINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOINT) == 0x360U, pic32_can_at_FIFO_0__FIFOINT);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOINTCLR) == 0x364U, pic32_can_at_FIFO_0__FIFOINTCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOINTSET) == 0x368U, pic32_can_at_FIFO_0__FIFOINTSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOINTINV) == 0x36CU, pic32_can_at_FIFO_0__FIFOINTINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOUA) == 0x370U, pic32_can_at_FIFO_0__FIFOUA);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOUACLR) == 0x374U, pic32_can_at_FIFO_0__FIFOUACLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOUASET) == 0x378U, pic32_can_at_FIFO_0__FIFOUASET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOUAINV) == 0x37CU, pic32_can_at_FIFO_0__FIFOUAINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOCI) == 0x380U, pic32_can_at_FIFO_0__FIFOCI);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOCICLR) == 0x384U, pic32_can_at_FIFO_0__FIFOCICLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOCISET) == 0x388U, pic32_can_at_FIFO_0__FIFOCISET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[0].FIFOCIINV) == 0x38CU, pic32_can_at_FIFO_0__FIFOCIINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOCON) == 0x390U, pic32_can_at_FIFO_1__FIFOCON);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOCONCLR) == 0x394U, pic32_can_at_FIFO_1__FIFOCONCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOCONSET) == 0x398U, pic32_can_at_FIFO_1__FIFOCONSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOCONINV) == 0x39CU, pic32_can_at_FIFO_1__FIFOCONINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOINT) == 0x3A0U, pic32_can_at_FIFO_1__FIFOINT);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOINTCLR) == 0x3A4U, pic32_can_at_FIFO_1__FIFOINTCLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOINTSET) == 0x3A8U, pic32_can_at_FIFO_1__FIFOINTSET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOINTINV) == 0x3ACU, pic32_can_at_FIFO_1__FIFOINTINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOUA) == 0x3B0U, pic32_can_at_FIFO_1__FIFOUA);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOUACLR) == 0x3B4U, pic32_can_at_FIFO_1__FIFOUACLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOUASET) == 0x3B8U, pic32_can_at_FIFO_1__FIFOUASET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOUAINV) == 0x3BCU, pic32_can_at_FIFO_1__FIFOUAINV);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOCI) == 0x3C0U, pic32_can_at_FIFO_1__FIFOCI);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOCICLR) == 0x3C4U, pic32_can_at_FIFO_1__FIFOCICLR);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOCISET) == 0x3C8U, pic32_can_at_FIFO_1__FIFOCISET);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_regs_t, FIFO[1].FIFOCIINV) == 0x3CCU, pic32_can_at_FIFO_1__FIFOCIINV);
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_regs_t) == 0xB50U, pic32_can_span);

/* CON: CAN Control Register.
 * Operating mode, module enable, abort of all transmissions, time stamping and DeviceNet filtering.
 * Hazard: A requested mode is in force only when OPMOD shows it; poll OPMOD before relying on it.
 * Hazard: Go to Configuration mode before clearing ON, or a message being sent is cut off on the bus; afterwards
 * poll CANBUSY until it is 0.
 * Hazard: Entering Configuration mode and clearing ON both reset all 32 FIFOs, so a short visit to Configuration
 * mode drops every queued and unread message.
 * Hazard: The configuration steps and examples of the manual never set ON; the module does nothing until it is
 * set.
 * Hazard: Put the module into Disable mode before the device goes to Sleep, or to Idle with SIDLE set. Waking up
 * does not change the mode: software has to go back to Normal mode, and the message that woke the device is
 * lost.
 * Hazard: Bit 14 is reserved and not to be used; leave it 0.
 * Contradictions of the manual: register_summary_columns.
 * Register 34-1 p.14; Table 34-1 p.11 (offset)
 */
#define PIC32_CAN_CON_OFFSET 0x000U
#define PIC32_CAN_CON_RESET UINT32_C(0x04800000)
#define PIC32_CAN_CON_RESET_MASK UINT32_C(0xFFFFFFFF)
/* ABAT: Set to abort the pending transmissions of all transmit FIFOs. Hardware clears it when all of them are
 * aborted. Access w1s. A request: writing 1 makes it, writing 0 does nothing, hardware clears it.
 */
#define PIC32_CAN_CON_ABAT_Pos 27U
#define PIC32_CAN_CON_ABAT_Msk UINT32_C(0x08000000)
#define PIC32_CAN_CON_ABAT_Width 1U
#define PIC32_CAN_CON_ABAT_Access "w1s"
static inline uint32_t pic32_can_con_abat_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CON_ABAT_Msk) >> PIC32_CAN_CON_ABAT_Pos);
}
/* REQOP: Requested operating mode. The change happens in step with the bus and is acknowledged in OPMOD. Access
 * rw.
 * Contradictions of the manual: decimal_mode_code.
 */
#define PIC32_CAN_CON_REQOP_Pos 24U
#define PIC32_CAN_CON_REQOP_Msk UINT32_C(0x07000000)
#define PIC32_CAN_CON_REQOP_Width 3U
#define PIC32_CAN_CON_REQOP_Access "rw"
#define PIC32_CAN_CON_REQOP_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CON_REQOP_Pos) & PIC32_CAN_CON_REQOP_Msk))
static inline uint32_t pic32_can_con_reqop_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CON_REQOP_Msk) >> PIC32_CAN_CON_REQOP_Pos);
}
static inline uint32_t pic32_can_con_reqop_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CON_REQOP_Msk) | PIC32_CAN_CON_REQOP_SET(value));
}
/* OPMOD: Operating mode the module is in. Access ro.
 * Contradictions of the manual: decimal_mode_code.
 * Register 34-1 p.15
 */
#define PIC32_CAN_CON_OPMOD_Pos 21U
#define PIC32_CAN_CON_OPMOD_Msk UINT32_C(0x00E00000)
#define PIC32_CAN_CON_OPMOD_Width 3U
#define PIC32_CAN_CON_OPMOD_Access "ro"
static inline uint32_t pic32_can_con_opmod_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CON_OPMOD_Msk) >> PIC32_CAN_CON_OPMOD_Pos);
}
/* CANCAP: 1 runs the time stamp timer and stores its value with every valid received message; 0 stops the timer
 * to save power and captures nothing. Access rw.
 * Contradictions of the manual: cantmr_name.
 * Register 34-1 p.15
 */
#define PIC32_CAN_CON_CANCAP_Pos 20U
#define PIC32_CAN_CON_CANCAP_Msk UINT32_C(0x00100000)
#define PIC32_CAN_CON_CANCAP_Width 1U
#define PIC32_CAN_CON_CANCAP_Access "rw"
#define PIC32_CAN_CON_CANCAP_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CON_CANCAP_Pos) & PIC32_CAN_CON_CANCAP_Msk))
static inline uint32_t pic32_can_con_cancap_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CON_CANCAP_Msk) >> PIC32_CAN_CON_CANCAP_Pos);
}
static inline uint32_t pic32_can_con_cancap_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CON_CANCAP_Msk) | PIC32_CAN_CON_CANCAP_SET(value));
}
/* ON: 1 enables the module and claims the pins CiTX and CiRX. 0 holds the whole module in reset, with only its
 * registers accessible, and releases the pins; this can take a number of cycles, which CANBUSY shows. Access rw.
 * Contradictions of the manual: on_missing_in_steps.
 * Register 34-1 p.15; §34.4 p.52
 */
#define PIC32_CAN_CON_ON_Pos 15U
#define PIC32_CAN_CON_ON_Msk UINT32_C(0x00008000)
#define PIC32_CAN_CON_ON_Width 1U
#define PIC32_CAN_CON_ON_Access "rw"
#define PIC32_CAN_CON_ON_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CON_ON_Pos) & PIC32_CAN_CON_ON_Msk))
static inline uint32_t pic32_can_con_on_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CON_ON_Msk) >> PIC32_CAN_CON_ON_Pos);
}
static inline uint32_t pic32_can_con_on_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CON_ON_Msk) | PIC32_CAN_CON_ON_SET(value));
}
/* SIDLE: 1 stops the module while the device is in Idle mode, 0 lets it run on. Access rw.
 * Register 34-1 p.15; §34.14.2 p.98
 */
#define PIC32_CAN_CON_SIDLE_Pos 13U
#define PIC32_CAN_CON_SIDLE_Msk UINT32_C(0x00002000)
#define PIC32_CAN_CON_SIDLE_Width 1U
#define PIC32_CAN_CON_SIDLE_Access "rw"
#define PIC32_CAN_CON_SIDLE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CON_SIDLE_Pos) & PIC32_CAN_CON_SIDLE_Msk))
static inline uint32_t pic32_can_con_sidle_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CON_SIDLE_Msk) >> PIC32_CAN_CON_SIDLE_Pos);
}
static inline uint32_t pic32_can_con_sidle_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CON_SIDLE_Msk) | PIC32_CAN_CON_SIDLE_SET(value));
}
/* CANBUSY: 1 while the module is active, 0 when it is completely disabled. Poll it after clearing ON and after a
 * system error. Access ro.
 * Contradictions of the manual: canbusy_name.
 * Register 34-1 p.15; §34.4 p.52; §34.12.1.4 p.95
 */
#define PIC32_CAN_CON_CANBUSY_Pos 11U
#define PIC32_CAN_CON_CANBUSY_Msk UINT32_C(0x00000800)
#define PIC32_CAN_CON_CANBUSY_Width 1U
#define PIC32_CAN_CON_CANBUSY_Access "ro"
static inline uint32_t pic32_can_con_canbusy_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CON_CANBUSY_Msk) >> PIC32_CAN_CON_CANBUSY_Pos);
}
/* DNCNT: DeviceNet filtering: number of leading data bits of a standard message that must match the EID bits of
 * the filter in addition to the SID. A message with less data is compared over the bits it has. Access rw.
 * Contradictions of the manual: dncnt_above_18, devicenet_bit_order.
 * Register 34-1 p.15; §34.8.7 p.78; Table 34-4 p.79
 */
#define PIC32_CAN_CON_DNCNT_Pos 0U
#define PIC32_CAN_CON_DNCNT_Msk UINT32_C(0x0000001F)
#define PIC32_CAN_CON_DNCNT_Width 5U
#define PIC32_CAN_CON_DNCNT_Access "rw"
#define PIC32_CAN_CON_DNCNT_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CON_DNCNT_Pos) & PIC32_CAN_CON_DNCNT_Msk))
static inline uint32_t pic32_can_con_dncnt_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CON_DNCNT_Msk) >> PIC32_CAN_CON_DNCNT_Pos);
}
static inline uint32_t pic32_can_con_dncnt_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 31U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CON_DNCNT_Msk) | PIC32_CAN_CON_DNCNT_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void pic32_can_con_modify(pic32_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->CON;
    value = (uint32_t)((value & (uint32_t)~UINT32_C(0x08E00800)) | UINT32_C(0x00000000));
    regs->CON = (uint32_t)((value & (uint32_t)~clear) | set);
}
/* Clears the given bits: one store to the CLR register. */
static inline void pic32_can_con_clr(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->CONCLR = bits;
}
/* Sets the given bits: one store to the SET register. */
static inline void pic32_can_con_set(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->CONSET = bits;
}
/* Inverts the given bits: one store to the INV register. */
static inline void pic32_can_con_inv(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->CONINV = bits;
}

/* CFG: CAN Baud Rate Configuration Register.
 * Bit timing and the wake-up filter of the receive pin.
 * Contradictions of the manual: cantspre_brp_cfg_names.
 * Register 34-2 p.16; Table 34-1 p.11 (offset)
 */
#define PIC32_CAN_CFG_OFFSET 0x010U
#define PIC32_CAN_CFG_RESET UINT32_C(0x00000000)
#define PIC32_CAN_CFG_RESET_MASK UINT32_C(0xFFFFFFFF)
/* WAKFIL: 1 puts the low-pass filter on CiRX in front of wake-up detection in Disable, Sleep and Idle mode, 0
 * leaves it out. Access rw:configuration. A write has an effect only if configuration (CON.OPMOD ==
 * configuration).
 * Register 34-2 p.16; §34.14.3 p.98
 */
#define PIC32_CAN_CFG_WAKFIL_Pos 22U
#define PIC32_CAN_CFG_WAKFIL_Msk UINT32_C(0x00400000)
#define PIC32_CAN_CFG_WAKFIL_Width 1U
#define PIC32_CAN_CFG_WAKFIL_Access "rw:configuration"
#define PIC32_CAN_CFG_WAKFIL_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CFG_WAKFIL_Pos) & PIC32_CAN_CFG_WAKFIL_Msk))
static inline uint32_t pic32_can_cfg_wakfil_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CFG_WAKFIL_Msk) >> PIC32_CAN_CFG_WAKFIL_Pos);
}
static inline uint32_t pic32_can_cfg_wakfil_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CFG_WAKFIL_Msk) | PIC32_CAN_CFG_WAKFIL_SET(value));
}
/* SEG2PH: Phase buffer segment 2, 1 to 8 time quanta. Not longer than phase buffer segment 1. With SEG2PHTS = 0
 * the module sets it by itself. Access rw:configuration. A write has an effect only if configuration (CON.OPMOD
 * == configuration). Means value + 1 tq.
 * Contradictions of the manual: jump_width_limit, segment2_limit.
 */
#define PIC32_CAN_CFG_SEG2PH_Pos 16U
#define PIC32_CAN_CFG_SEG2PH_Msk UINT32_C(0x00070000)
#define PIC32_CAN_CFG_SEG2PH_Width 3U
#define PIC32_CAN_CFG_SEG2PH_Access "rw:configuration"
#define PIC32_CAN_CFG_SEG2PH_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CFG_SEG2PH_Pos) & PIC32_CAN_CFG_SEG2PH_Msk))
static inline uint32_t pic32_can_cfg_seg2ph_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CFG_SEG2PH_Msk) >> PIC32_CAN_CFG_SEG2PH_Pos);
}
static inline uint32_t pic32_can_cfg_seg2ph_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CFG_SEG2PH_Msk) | PIC32_CAN_CFG_SEG2PH_SET(value));
}
/* SEG2PHTS: How the length of phase buffer segment 2 is determined. Access rw:configuration. A write has an
 * effect only if configuration (CON.OPMOD == configuration).
 * Register 34-2 p.17
 */
#define PIC32_CAN_CFG_SEG2PHTS_Pos 15U
#define PIC32_CAN_CFG_SEG2PHTS_Msk UINT32_C(0x00008000)
#define PIC32_CAN_CFG_SEG2PHTS_Width 1U
#define PIC32_CAN_CFG_SEG2PHTS_Access "rw:configuration"
#define PIC32_CAN_CFG_SEG2PHTS_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CFG_SEG2PHTS_Pos) & PIC32_CAN_CFG_SEG2PHTS_Msk))
static inline uint32_t pic32_can_cfg_seg2phts_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CFG_SEG2PHTS_Msk) >> PIC32_CAN_CFG_SEG2PHTS_Pos);
}
static inline uint32_t pic32_can_cfg_seg2phts_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CFG_SEG2PHTS_Msk) | PIC32_CAN_CFG_SEG2PHTS_SET(value));
}
/* SAM: Number of samples at the sample point. Access rw:configuration. A write has an effect only if
 * configuration (CON.OPMOD == configuration).
 * Register 34-2 p.17
 */
#define PIC32_CAN_CFG_SAM_Pos 14U
#define PIC32_CAN_CFG_SAM_Msk UINT32_C(0x00004000)
#define PIC32_CAN_CFG_SAM_Width 1U
#define PIC32_CAN_CFG_SAM_Access "rw:configuration"
#define PIC32_CAN_CFG_SAM_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CFG_SAM_Pos) & PIC32_CAN_CFG_SAM_Msk))
static inline uint32_t pic32_can_cfg_sam_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CFG_SAM_Msk) >> PIC32_CAN_CFG_SAM_Pos);
}
static inline uint32_t pic32_can_cfg_sam_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CFG_SAM_Msk) | PIC32_CAN_CFG_SAM_SET(value));
}
/* SEG1PH: Phase buffer segment 1, 1 to 8 time quanta. Access rw:configuration. A write has an effect only if
 * configuration (CON.OPMOD == configuration). Means value + 1 tq.
 * Contradictions of the manual: segment2_limit.
 * Register 34-2 p.17
 */
#define PIC32_CAN_CFG_SEG1PH_Pos 11U
#define PIC32_CAN_CFG_SEG1PH_Msk UINT32_C(0x00003800)
#define PIC32_CAN_CFG_SEG1PH_Width 3U
#define PIC32_CAN_CFG_SEG1PH_Access "rw:configuration"
#define PIC32_CAN_CFG_SEG1PH_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CFG_SEG1PH_Pos) & PIC32_CAN_CFG_SEG1PH_Msk))
static inline uint32_t pic32_can_cfg_seg1ph_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CFG_SEG1PH_Msk) >> PIC32_CAN_CFG_SEG1PH_Pos);
}
static inline uint32_t pic32_can_cfg_seg1ph_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CFG_SEG1PH_Msk) | PIC32_CAN_CFG_SEG1PH_SET(value));
}
/* PRSEG: Propagation segment, 1 to 8 time quanta. Access rw:configuration. A write has an effect only if
 * configuration (CON.OPMOD == configuration). Means value + 1 tq.
 * Contradictions of the manual: segment2_limit.
 * Register 34-2 p.17
 */
#define PIC32_CAN_CFG_PRSEG_Pos 8U
#define PIC32_CAN_CFG_PRSEG_Msk UINT32_C(0x00000700)
#define PIC32_CAN_CFG_PRSEG_Width 3U
#define PIC32_CAN_CFG_PRSEG_Access "rw:configuration"
#define PIC32_CAN_CFG_PRSEG_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CFG_PRSEG_Pos) & PIC32_CAN_CFG_PRSEG_Msk))
static inline uint32_t pic32_can_cfg_prseg_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CFG_PRSEG_Msk) >> PIC32_CAN_CFG_PRSEG_Pos);
}
static inline uint32_t pic32_can_cfg_prseg_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CFG_PRSEG_Msk) | PIC32_CAN_CFG_PRSEG_SET(value));
}
/* SJW: Synchronization jump width, 1 to 4 time quanta. Not longer than phase buffer segment 2. Access
 * rw:configuration. A write has an effect only if configuration (CON.OPMOD == configuration). Means value + 1
 * tq.
 * Contradictions of the manual: jump_width_limit, sjw_of_two_quanta.
 * Register 34-2 p.17
 */
#define PIC32_CAN_CFG_SJW_Pos 6U
#define PIC32_CAN_CFG_SJW_Msk UINT32_C(0x000000C0)
#define PIC32_CAN_CFG_SJW_Width 2U
#define PIC32_CAN_CFG_SJW_Access "rw:configuration"
#define PIC32_CAN_CFG_SJW_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CFG_SJW_Pos) & PIC32_CAN_CFG_SJW_Msk))
static inline uint32_t pic32_can_cfg_sjw_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CFG_SJW_Msk) >> PIC32_CAN_CFG_SJW_Pos);
}
static inline uint32_t pic32_can_cfg_sjw_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CFG_SJW_Msk) | PIC32_CAN_CFG_SJW_SET(value));
}
/* BRP: Baud rate prescaler. A time quantum lasts 2 * (BRP + 1) periods of the system clock FSYS. Access
 * rw:configuration. A write has an effect only if configuration (CON.OPMOD == configuration). Means value + 1
 * FSYS / 2 periods.
 * Contradictions of the manual: cantspre_brp_cfg_names, clock_of_time_quantum, time_quantum_frequency.
 * Register 34-2 p.17
 */
#define PIC32_CAN_CFG_BRP_Pos 0U
#define PIC32_CAN_CFG_BRP_Msk UINT32_C(0x0000003F)
#define PIC32_CAN_CFG_BRP_Width 6U
#define PIC32_CAN_CFG_BRP_Access "rw:configuration"
#define PIC32_CAN_CFG_BRP_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_CFG_BRP_Pos) & PIC32_CAN_CFG_BRP_Msk))
static inline uint32_t pic32_can_cfg_brp_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_CFG_BRP_Msk) >> PIC32_CAN_CFG_BRP_Pos);
}
static inline uint32_t pic32_can_cfg_brp_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 63U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_CFG_BRP_Msk) | PIC32_CAN_CFG_BRP_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void pic32_can_cfg_modify(pic32_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->CFG;
    regs->CFG = (uint32_t)((value & (uint32_t)~clear) | set);
}
/* Clears the given bits: one store to the CLR register. */
static inline void pic32_can_cfg_clr(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->CFGCLR = bits;
}
/* Sets the given bits: one store to the SET register. */
static inline void pic32_can_cfg_set(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->CFGSET = bits;
}
/* Inverts the given bits: one store to the INV register. */
static inline void pic32_can_cfg_inv(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->CFGINV = bits;
}

/* INT: CAN Interrupt Register.
 * Enables (bits 31:16) and flags (bits 15:0) of the nine interrupts of layer 2.
 * Hazard: Enables and flags share this register. Writing back what was read clears flags that were raised in
 * between: clear flags through CiINTCLR, change enables through CiINTSET and CiINTCLR.
 * Hazard: TBIF, RBIF and RBOVIF follow the FIFOs and SERRIF the ON bit; writing to them achieves nothing.
 * Hazard: MODIF is also raised by mode changes that the software itself requested; clear it before enabling
 * MODIE.
 * Register 34-3 p.18; Table 34-1 p.11 (offset)
 */
#define PIC32_CAN_INT_OFFSET 0x020U
#define PIC32_CAN_INT_RESET UINT32_C(0x00000000)
#define PIC32_CAN_INT_RESET_MASK UINT32_C(0xFFFFFFFF)
/* IVRIE: Enables the invalid message interrupt. Access rw.
 * Contradictions of the manual: invalid_message_direction.
 */
#define PIC32_CAN_INT_IVRIE_Pos 31U
#define PIC32_CAN_INT_IVRIE_Msk UINT32_C(0x80000000)
#define PIC32_CAN_INT_IVRIE_Width 1U
#define PIC32_CAN_INT_IVRIE_Access "rw"
#define PIC32_CAN_INT_IVRIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_INT_IVRIE_Pos) & PIC32_CAN_INT_IVRIE_Msk))
static inline uint32_t pic32_can_int_ivrie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_IVRIE_Msk) >> PIC32_CAN_INT_IVRIE_Pos);
}
static inline uint32_t pic32_can_int_ivrie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_INT_IVRIE_Msk) | PIC32_CAN_INT_IVRIE_SET(value));
}
/* WAKIE: Enables the wake-up interrupt for bus activity. Access rw. */
#define PIC32_CAN_INT_WAKIE_Pos 30U
#define PIC32_CAN_INT_WAKIE_Msk UINT32_C(0x40000000)
#define PIC32_CAN_INT_WAKIE_Width 1U
#define PIC32_CAN_INT_WAKIE_Access "rw"
#define PIC32_CAN_INT_WAKIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_INT_WAKIE_Pos) & PIC32_CAN_INT_WAKIE_Msk))
static inline uint32_t pic32_can_int_wakie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_WAKIE_Msk) >> PIC32_CAN_INT_WAKIE_Pos);
}
static inline uint32_t pic32_can_int_wakie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_INT_WAKIE_Msk) | PIC32_CAN_INT_WAKIE_SET(value));
}
/* CERRIE: Enables the bus error interrupt. Access rw. */
#define PIC32_CAN_INT_CERRIE_Pos 29U
#define PIC32_CAN_INT_CERRIE_Msk UINT32_C(0x20000000)
#define PIC32_CAN_INT_CERRIE_Width 1U
#define PIC32_CAN_INT_CERRIE_Access "rw"
#define PIC32_CAN_INT_CERRIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_INT_CERRIE_Pos) & PIC32_CAN_INT_CERRIE_Msk))
static inline uint32_t pic32_can_int_cerrie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_CERRIE_Msk) >> PIC32_CAN_INT_CERRIE_Pos);
}
static inline uint32_t pic32_can_int_cerrie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_INT_CERRIE_Msk) | PIC32_CAN_INT_CERRIE_SET(value));
}
/* SERRIE: Enables the system error interrupt. Access rw. */
#define PIC32_CAN_INT_SERRIE_Pos 28U
#define PIC32_CAN_INT_SERRIE_Msk UINT32_C(0x10000000)
#define PIC32_CAN_INT_SERRIE_Width 1U
#define PIC32_CAN_INT_SERRIE_Access "rw"
#define PIC32_CAN_INT_SERRIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_INT_SERRIE_Pos) & PIC32_CAN_INT_SERRIE_Msk))
static inline uint32_t pic32_can_int_serrie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_SERRIE_Msk) >> PIC32_CAN_INT_SERRIE_Pos);
}
static inline uint32_t pic32_can_int_serrie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_INT_SERRIE_Msk) | PIC32_CAN_INT_SERRIE_SET(value));
}
/* RBOVIE: Enables the receive overflow interrupt. Access rw. */
#define PIC32_CAN_INT_RBOVIE_Pos 27U
#define PIC32_CAN_INT_RBOVIE_Msk UINT32_C(0x08000000)
#define PIC32_CAN_INT_RBOVIE_Width 1U
#define PIC32_CAN_INT_RBOVIE_Access "rw"
#define PIC32_CAN_INT_RBOVIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_INT_RBOVIE_Pos) & PIC32_CAN_INT_RBOVIE_Msk))
static inline uint32_t pic32_can_int_rbovie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_RBOVIE_Msk) >> PIC32_CAN_INT_RBOVIE_Pos);
}
static inline uint32_t pic32_can_int_rbovie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_INT_RBOVIE_Msk) | PIC32_CAN_INT_RBOVIE_SET(value));
}
/* MODIE: Enables the mode change interrupt. Access rw.
 * Register 34-3 p.19
 */
#define PIC32_CAN_INT_MODIE_Pos 19U
#define PIC32_CAN_INT_MODIE_Msk UINT32_C(0x00080000)
#define PIC32_CAN_INT_MODIE_Width 1U
#define PIC32_CAN_INT_MODIE_Access "rw"
#define PIC32_CAN_INT_MODIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_INT_MODIE_Pos) & PIC32_CAN_INT_MODIE_Msk))
static inline uint32_t pic32_can_int_modie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_MODIE_Msk) >> PIC32_CAN_INT_MODIE_Pos);
}
static inline uint32_t pic32_can_int_modie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_INT_MODIE_Msk) | PIC32_CAN_INT_MODIE_SET(value));
}
/* CTMRIE: Enables the time stamp timer interrupt. Access rw.
 * Register 34-3 p.19
 */
#define PIC32_CAN_INT_CTMRIE_Pos 18U
#define PIC32_CAN_INT_CTMRIE_Msk UINT32_C(0x00040000)
#define PIC32_CAN_INT_CTMRIE_Width 1U
#define PIC32_CAN_INT_CTMRIE_Access "rw"
#define PIC32_CAN_INT_CTMRIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_INT_CTMRIE_Pos) & PIC32_CAN_INT_CTMRIE_Msk))
static inline uint32_t pic32_can_int_ctmrie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_CTMRIE_Msk) >> PIC32_CAN_INT_CTMRIE_Pos);
}
static inline uint32_t pic32_can_int_ctmrie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_INT_CTMRIE_Msk) | PIC32_CAN_INT_CTMRIE_SET(value));
}
/* RBIE: Enables the interrupt of the receive FIFOs. Access rw.
 * Register 34-3 p.19
 */
#define PIC32_CAN_INT_RBIE_Pos 17U
#define PIC32_CAN_INT_RBIE_Msk UINT32_C(0x00020000)
#define PIC32_CAN_INT_RBIE_Width 1U
#define PIC32_CAN_INT_RBIE_Access "rw"
#define PIC32_CAN_INT_RBIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_INT_RBIE_Pos) & PIC32_CAN_INT_RBIE_Msk))
static inline uint32_t pic32_can_int_rbie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_RBIE_Msk) >> PIC32_CAN_INT_RBIE_Pos);
}
static inline uint32_t pic32_can_int_rbie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_INT_RBIE_Msk) | PIC32_CAN_INT_RBIE_SET(value));
}
/* TBIE: Enables the interrupt of the transmit FIFOs. Access rw.
 * Register 34-3 p.19
 */
#define PIC32_CAN_INT_TBIE_Pos 16U
#define PIC32_CAN_INT_TBIE_Msk UINT32_C(0x00010000)
#define PIC32_CAN_INT_TBIE_Width 1U
#define PIC32_CAN_INT_TBIE_Access "rw"
#define PIC32_CAN_INT_TBIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_INT_TBIE_Pos) & PIC32_CAN_INT_TBIE_Msk))
static inline uint32_t pic32_can_int_tbie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_TBIE_Msk) >> PIC32_CAN_INT_TBIE_Pos);
}
static inline uint32_t pic32_can_int_tbie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_INT_TBIE_Msk) | PIC32_CAN_INT_TBIE_SET(value));
}
/* IVRIF: An error occurred in the last message sent or received; which one is not recorded. Access w0c. A flag:
 * writing 0 clears it, writing 1 does nothing.
 * Contradictions of the manual: invalid_message_direction.
 * Register 34-3 p.19; §34.12.1.1 p.95
 */
#define PIC32_CAN_INT_IVRIF_Pos 15U
#define PIC32_CAN_INT_IVRIF_Msk UINT32_C(0x00008000)
#define PIC32_CAN_INT_IVRIF_Width 1U
#define PIC32_CAN_INT_IVRIF_Access "w0c"
static inline uint32_t pic32_can_int_ivrif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_IVRIF_Msk) >> PIC32_CAN_INT_IVRIF_Pos);
}
/* WAKIF: Bus activity was detected while the module was sleeping. Access w0c. A flag: writing 0 clears it,
 * writing 1 does nothing.
 * Register 34-3 p.19; §34.12.1.2 p.95; §34.14.3 p.98
 */
#define PIC32_CAN_INT_WAKIF_Pos 14U
#define PIC32_CAN_INT_WAKIF_Msk UINT32_C(0x00004000)
#define PIC32_CAN_INT_WAKIF_Width 1U
#define PIC32_CAN_INT_WAKIF_Access "w0c"
static inline uint32_t pic32_can_int_wakif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_WAKIF_Msk) >> PIC32_CAN_INT_WAKIF_Pos);
}
/* CERRIF: An error counter crossed a threshold of CiTREC (warning, passive, bus off). Set once for each
 * crossing; after clearing it stays 0 while the counter stays above the threshold. Access w0c. A flag: writing 0
 * clears it, writing 1 does nothing.
 * Contradictions of the manual: bus_error_flag.
 * Register 34-3 p.19; §34.12.1.3 p.95
 */
#define PIC32_CAN_INT_CERRIF_Pos 13U
#define PIC32_CAN_INT_CERRIF_Msk UINT32_C(0x00002000)
#define PIC32_CAN_INT_CERRIF_Width 1U
#define PIC32_CAN_INT_CERRIF_Access "w0c"
static inline uint32_t pic32_can_int_cerrif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_CERRIF_Msk) >> PIC32_CAN_INT_CERRIF_Pos);
}
/* SERRIF: Fatal addressing or bus bandwidth error on the system bus; the module stops. Wait for CANBUSY = 0 and
 * clear ON: nothing else clears the flag. ICOD tells the two errors apart. Access ro.
 * Contradictions of the manual: serrif_clearing.
 * Register 34-3 p.19; §34.12.1.4 p.95
 */
#define PIC32_CAN_INT_SERRIF_Pos 12U
#define PIC32_CAN_INT_SERRIF_Msk UINT32_C(0x00001000)
#define PIC32_CAN_INT_SERRIF_Width 1U
#define PIC32_CAN_INT_SERRIF_Access "ro"
static inline uint32_t pic32_can_int_serrif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_SERRIF_Msk) >> PIC32_CAN_INT_SERRIF_Pos);
}
/* RBOVIF: At least one bit of CiRXOVF is set. Cleared by clearing RXOVFLIF of the FIFOs concerned. Access ro.
 * Contradictions of the manual: layer3_names, derived_flags_drawn_writable.
 * Register 34-3 p.19; §34.12.1.7 p.96
 */
#define PIC32_CAN_INT_RBOVIF_Pos 11U
#define PIC32_CAN_INT_RBOVIF_Msk UINT32_C(0x00000800)
#define PIC32_CAN_INT_RBOVIF_Width 1U
#define PIC32_CAN_INT_RBOVIF_Access "ro"
static inline uint32_t pic32_can_int_rbovif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_RBOVIF_Msk) >> PIC32_CAN_INT_RBOVIF_Pos);
}
/* MODIF: OPMOD changed. Access w0c. A flag: writing 0 clears it, writing 1 does nothing.
 * Register 34-3 p.19; §34.12.1.8 p.96
 */
#define PIC32_CAN_INT_MODIF_Pos 3U
#define PIC32_CAN_INT_MODIF_Msk UINT32_C(0x00000008)
#define PIC32_CAN_INT_MODIF_Width 1U
#define PIC32_CAN_INT_MODIF_Access "w0c"
static inline uint32_t pic32_can_int_modif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_MODIF_Msk) >> PIC32_CAN_INT_MODIF_Pos);
}
/* CTMRIF: The time stamp timer CANTS overflowed. Access w0c. A flag: writing 0 clears it, writing 1 does
 * nothing.
 * Contradictions of the manual: cantmr_name.
 * Register 34-3 p.19; §34.12.1.9 p.96
 */
#define PIC32_CAN_INT_CTMRIF_Pos 2U
#define PIC32_CAN_INT_CTMRIF_Msk UINT32_C(0x00000004)
#define PIC32_CAN_INT_CTMRIF_Width 1U
#define PIC32_CAN_INT_CTMRIF_Access "w0c"
static inline uint32_t pic32_can_int_ctmrif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_CTMRIF_Msk) >> PIC32_CAN_INT_CTMRIF_Pos);
}
/* RBIF: An enabled not-empty, half-full or full flag of a receive FIFO is pending. Goes away with its causes.
 * Access ro.
 * Contradictions of the manual: derived_flags_drawn_writable.
 * Register 34-3 p.19; §34.12.1.11 p.96
 */
#define PIC32_CAN_INT_RBIF_Pos 1U
#define PIC32_CAN_INT_RBIF_Msk UINT32_C(0x00000002)
#define PIC32_CAN_INT_RBIF_Width 1U
#define PIC32_CAN_INT_RBIF_Access "ro"
static inline uint32_t pic32_can_int_rbif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_RBIF_Msk) >> PIC32_CAN_INT_RBIF_Pos);
}
/* TBIF: An enabled not-full, half-full or empty flag of a transmit FIFO is pending. Goes away with its causes.
 * Access ro.
 * Contradictions of the manual: derived_flags_drawn_writable.
 * Register 34-3 p.19; §34.12.1.10 p.96
 */
#define PIC32_CAN_INT_TBIF_Pos 0U
#define PIC32_CAN_INT_TBIF_Msk UINT32_C(0x00000001)
#define PIC32_CAN_INT_TBIF_Width 1U
#define PIC32_CAN_INT_TBIF_Access "ro"
static inline uint32_t pic32_can_int_tbif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_INT_TBIF_Msk) >> PIC32_CAN_INT_TBIF_Pos);
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void pic32_can_int_modify(pic32_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->INT;
    value = (uint32_t)((value & (uint32_t)~UINT32_C(0x00001803)) | UINT32_C(0x0000E00C));
    regs->INT = (uint32_t)((value & (uint32_t)~clear) | set);
}
/* Clears the given bits: one store to the CLR register. */
static inline void pic32_can_int_clr(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->INTCLR = bits;
}
/* Sets the given bits: one store to the SET register. */
static inline void pic32_can_int_set(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->INTSET = bits;
}
/* Inverts the given bits: one store to the INV register. */
static inline void pic32_can_int_inv(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->INTINV = bits;
}

/* VEC: CAN Interrupt Code Register.
 * Code of the pending interrupt, for a jump table, and number of the filter that matched last.
 * Register 34-4 p.20; Table 34-1 p.11 (offset)
 */
#define PIC32_CAN_VEC_OFFSET 0x030U
#define PIC32_CAN_VEC_RESET UINT32_C(0x00000040)
#define PIC32_CAN_VEC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* FILHIT: Filter that matched the latest received message. The next reception overwrites it; clearing interrupts
 * does not. Access ro.
 * Register 34-4 p.20; §34.12.7
 */
#define PIC32_CAN_VEC_FILHIT_Pos 8U
#define PIC32_CAN_VEC_FILHIT_Msk UINT32_C(0x00001F00)
#define PIC32_CAN_VEC_FILHIT_Width 5U
#define PIC32_CAN_VEC_FILHIT_Access "ro"
static inline uint32_t pic32_can_vec_filhit_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_VEC_FILHIT_Msk) >> PIC32_CAN_VEC_FILHIT_Pos);
}
/* ICOD: Code of the highest pending interrupt. Interrupts that are not enabled do not show here, so it stays at
 * no_interrupt however many of their flags are set. Access ro.
 * Contradictions of the manual: icod_name, icod_latest_or_highest.
 * Register 34-4 p.21; §34.12.6
 */
#define PIC32_CAN_VEC_ICOD_Pos 0U
#define PIC32_CAN_VEC_ICOD_Msk UINT32_C(0x0000007F)
#define PIC32_CAN_VEC_ICOD_Width 7U
#define PIC32_CAN_VEC_ICOD_Access "ro"
static inline uint32_t pic32_can_vec_icod_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_VEC_ICOD_Msk) >> PIC32_CAN_VEC_ICOD_Pos);
}

/* TREC: CAN Transmit/Receive Error Count Register.
 * Error counters and the error states that follow from them.
 * Register 34-5 p.22; Table 34-1 p.11 (offset)
 */
#define PIC32_CAN_TREC_OFFSET 0x040U
#define PIC32_CAN_TREC_RESET UINT32_C(0x00000000)
#define PIC32_CAN_TREC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TXBO: Transmitter is bus off, transmit error count 256 or more. The eight bits of TEC cannot show that count.
 * Access ro.
 * Register 34-5 p.22; §34.11.2.3
 */
#define PIC32_CAN_TREC_TXBO_Pos 21U
#define PIC32_CAN_TREC_TXBO_Msk UINT32_C(0x00200000)
#define PIC32_CAN_TREC_TXBO_Width 1U
#define PIC32_CAN_TREC_TXBO_Access "ro"
static inline uint32_t pic32_can_trec_txbo_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TREC_TXBO_Msk) >> PIC32_CAN_TREC_TXBO_Pos);
}
/* TXBP: Transmitter is error passive, transmit error count 128 or more. Access ro.
 * Contradictions of the manual: error_passive_threshold.
 * Register 34-5 p.22; §34.11.2.1
 */
#define PIC32_CAN_TREC_TXBP_Pos 20U
#define PIC32_CAN_TREC_TXBP_Msk UINT32_C(0x00100000)
#define PIC32_CAN_TREC_TXBP_Width 1U
#define PIC32_CAN_TREC_TXBP_Access "ro"
static inline uint32_t pic32_can_trec_txbp_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TREC_TXBP_Msk) >> PIC32_CAN_TREC_TXBP_Pos);
}
/* RXBP: Receiver is error passive, receive error count 128 or more. Access ro.
 * Contradictions of the manual: error_passive_threshold.
 * Register 34-5 p.22; §34.11.2.2
 */
#define PIC32_CAN_TREC_RXBP_Pos 19U
#define PIC32_CAN_TREC_RXBP_Msk UINT32_C(0x00080000)
#define PIC32_CAN_TREC_RXBP_Width 1U
#define PIC32_CAN_TREC_RXBP_Access "ro"
static inline uint32_t pic32_can_trec_rxbp_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TREC_RXBP_Msk) >> PIC32_CAN_TREC_RXBP_Pos);
}
/* TXWARN: Transmitter is in the warning state, transmit error count 96 or more (and below 128, see conflict
 * warning_upper_bound). Access ro.
 * Contradictions of the manual: warning_upper_bound.
 * Register 34-5 p.22; §34.11.2.4
 */
#define PIC32_CAN_TREC_TXWARN_Pos 18U
#define PIC32_CAN_TREC_TXWARN_Msk UINT32_C(0x00040000)
#define PIC32_CAN_TREC_TXWARN_Width 1U
#define PIC32_CAN_TREC_TXWARN_Access "ro"
static inline uint32_t pic32_can_trec_txwarn_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TREC_TXWARN_Msk) >> PIC32_CAN_TREC_TXWARN_Pos);
}
/* RXWARN: Receiver is in the warning state, receive error count 96 or more (and below 128, see conflict
 * warning_upper_bound). Access ro.
 * Contradictions of the manual: warning_upper_bound.
 * Register 34-5 p.22; §34.11.2.5
 */
#define PIC32_CAN_TREC_RXWARN_Pos 17U
#define PIC32_CAN_TREC_RXWARN_Msk UINT32_C(0x00020000)
#define PIC32_CAN_TREC_RXWARN_Width 1U
#define PIC32_CAN_TREC_RXWARN_Access "ro"
static inline uint32_t pic32_can_trec_rxwarn_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TREC_RXWARN_Msk) >> PIC32_CAN_TREC_RXWARN_Pos);
}
/* EWARN: At least one of the two error counters is 96 or more. Access ro.
 * Register 34-5 p.22; §34.11.2.5
 */
#define PIC32_CAN_TREC_EWARN_Pos 16U
#define PIC32_CAN_TREC_EWARN_Msk UINT32_C(0x00010000)
#define PIC32_CAN_TREC_EWARN_Width 1U
#define PIC32_CAN_TREC_EWARN_Access "ro"
static inline uint32_t pic32_can_trec_ewarn_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TREC_EWARN_Msk) >> PIC32_CAN_TREC_EWARN_Pos);
}
/* TEC: Transmit error counter. Access ro. */
#define PIC32_CAN_TREC_TEC_Pos 8U
#define PIC32_CAN_TREC_TEC_Msk UINT32_C(0x0000FF00)
#define PIC32_CAN_TREC_TEC_Width 8U
#define PIC32_CAN_TREC_TEC_Access "ro"
static inline uint32_t pic32_can_trec_tec_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TREC_TEC_Msk) >> PIC32_CAN_TREC_TEC_Pos);
}
/* REC: Receive error counter. Access ro. */
#define PIC32_CAN_TREC_REC_Pos 0U
#define PIC32_CAN_TREC_REC_Msk UINT32_C(0x000000FF)
#define PIC32_CAN_TREC_REC_Width 8U
#define PIC32_CAN_TREC_REC_Access "ro"
static inline uint32_t pic32_can_trec_rec_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TREC_REC_Msk) >> PIC32_CAN_TREC_REC_Pos);
}

/* FSTAT: CAN FIFO Status Register.
 * One bit per FIFO that tells whether it has an enabled interrupt pending. It is an indication, no interrupt
 * source of its own.
 * Register 34-6 p.23; §34.12.4 p.97; Table 34-1 p.11 (offset)
 */
#define PIC32_CAN_FSTAT_OFFSET 0x050U
#define PIC32_CAN_FSTAT_RESET UINT32_C(0x00000000)
#define PIC32_CAN_FSTAT_RESET_MASK UINT32_C(0xFFFFFFFF)
/* FIFOIP: At least one of the six level flags of the FIFO (TXNFULLIF, TXHALFIF, TXEMPTYIF, RXFULLIF, RXHALFIF,
 * RXNEMPTYIF) is set and enabled. An overflow does not count. Access ro. Lane 0 is number 0 in the first
 * register.
 */
#define PIC32_CAN_FSTAT_FIFOIP_Pos(lane) (0U + 1U * (lane))
#define PIC32_CAN_FSTAT_FIFOIP_Msk(lane) ((uint32_t)(UINT32_C(0x00000001) << (1U * (lane))))
#define PIC32_CAN_FSTAT_FIFOIP_Lanes 32U
#define PIC32_CAN_FSTAT_FIFOIP_Width 1U
#define PIC32_CAN_FSTAT_FIFOIP_Access "ro"
static inline uint32_t pic32_can_fstat_fifoip_get(uint32_t reg, unsigned int lane)
{
    PIC32_CAN_ASSERT(lane < 32U);
    return (uint32_t)((reg & PIC32_CAN_FSTAT_FIFOIP_Msk(lane)) >> PIC32_CAN_FSTAT_FIFOIP_Pos(lane));
}

/* RXOVF: CAN Receive FIFO Overflow Status Register.
 * One bit per FIFO that tells whether it has overflowed.
 * Hazard: With RXOVFLIE = 0 an overflow of the FIFO does not show here, only in its RXOVFLIF.
 * Register 34-7 p.24; §34.12.5 p.97; Table 34-1 p.11 (offset)
 */
#define PIC32_CAN_RXOVF_OFFSET 0x060U
#define PIC32_CAN_RXOVF_RESET UINT32_C(0x00000000)
#define PIC32_CAN_RXOVF_RESET_MASK UINT32_C(0xFFFFFFFF)
/* RXOVF: The FIFO has overflowed and its RXOVFLIE is set. Cleared by clearing RXOVFLIF in CiFIFOINTn. Access ro.
 * Lane 0 is number 0 in the first register.
 * Contradictions of the manual: layer3_names.
 */
#define PIC32_CAN_RXOVF_RXOVF_Pos(lane) (0U + 1U * (lane))
#define PIC32_CAN_RXOVF_RXOVF_Msk(lane) ((uint32_t)(UINT32_C(0x00000001) << (1U * (lane))))
#define PIC32_CAN_RXOVF_RXOVF_Lanes 32U
#define PIC32_CAN_RXOVF_RXOVF_Width 1U
#define PIC32_CAN_RXOVF_RXOVF_Access "ro"
static inline uint32_t pic32_can_rxovf_rxovf_get(uint32_t reg, unsigned int lane)
{
    PIC32_CAN_ASSERT(lane < 32U);
    return (uint32_t)((reg & PIC32_CAN_RXOVF_RXOVF_Msk(lane)) >> PIC32_CAN_RXOVF_RXOVF_Pos(lane));
}

/* TMR: CAN Timer Register.
 * Time stamp timer and its prescaler. Frozen while CANCAP is 0.
 * Hazard: Any write to this register, also one that changes nothing, restarts the prescaler's hidden count;
 * CANTSPRE keeps its value.
 * Hazard: The timer runs on between the read and the write of a read-modify-write, so writing back CANTS sets
 * the clock back.
 * Register 34-8 p.25; Table 34-1 p.11 (offset)
 */
#define PIC32_CAN_TMR_OFFSET 0x070U
#define PIC32_CAN_TMR_RESET UINT32_C(0x00000000)
#define PIC32_CAN_TMR_RESET_MASK UINT32_C(0xFFFFFFFF)
/* CANTS: Free-running time stamp timer, advanced at the rate set by CANTSPRE while CANCAP is 1. Its overflow
 * raises CTMRIF. Access rwh. Read and write, but hardware changes it too: writing back a stale value undoes the
 * hardware.
 * Contradictions of the manual: cantmr_name.
 */
#define PIC32_CAN_TMR_CANTS_Pos 16U
#define PIC32_CAN_TMR_CANTS_Msk UINT32_C(0xFFFF0000)
#define PIC32_CAN_TMR_CANTS_Width 16U
#define PIC32_CAN_TMR_CANTS_Access "rwh"
#define PIC32_CAN_TMR_CANTS_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_TMR_CANTS_Pos) & PIC32_CAN_TMR_CANTS_Msk))
static inline uint32_t pic32_can_tmr_cants_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TMR_CANTS_Msk) >> PIC32_CAN_TMR_CANTS_Pos);
}
static inline uint32_t pic32_can_tmr_cants_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 65535U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_TMR_CANTS_Msk) | PIC32_CAN_TMR_CANTS_SET(value));
}
/* CANTSPRE: Number of system clocks for one step of CANTS; 0 steps it every system clock. Access rw. Means value
 * system clocks.
 * Contradictions of the manual: cantspre_brp_cfg_names, timestamp_prescaler.
 */
#define PIC32_CAN_TMR_CANTSPRE_Pos 0U
#define PIC32_CAN_TMR_CANTSPRE_Msk UINT32_C(0x0000FFFF)
#define PIC32_CAN_TMR_CANTSPRE_Width 16U
#define PIC32_CAN_TMR_CANTSPRE_Access "rw"
#define PIC32_CAN_TMR_CANTSPRE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_TMR_CANTSPRE_Pos) & PIC32_CAN_TMR_CANTSPRE_Msk))
static inline uint32_t pic32_can_tmr_cantspre_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TMR_CANTSPRE_Msk) >> PIC32_CAN_TMR_CANTSPRE_Pos);
}
static inline uint32_t pic32_can_tmr_cantspre_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 65535U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_TMR_CANTSPRE_Msk) | PIC32_CAN_TMR_CANTSPRE_SET(value));
}
/* Clears the given bits: one store to the CLR register. */
static inline void pic32_can_tmr_clr(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->TMRCLR = bits;
}
/* Sets the given bits: one store to the SET register. */
static inline void pic32_can_tmr_set(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->TMRSET = bits;
}
/* Inverts the given bits: one store to the INV register. */
static inline void pic32_can_tmr_inv(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->TMRINV = bits;
}
/* No read-modify-write: no value written to CANTS leaves it alone. Use the functions for single bits above. */

/* RXM: CAN Acceptance Filter Mask Register.
 * Bits of the identifier that a filter compares. A 1 includes the bit in the comparison, a 0 ignores it. Each
 * filter selects one of the four masks with MSEL.
 * Hazard: A mask cannot be changed while a filter that selects it is enabled, not even in Configuration mode.
 * Contradictions of the manual: register_summary_columns, mask_write_lock.
 * Register 34-9 p.26; §34.8.3 p.75; Table 34-1 p.11 (offset)
 */
#define PIC32_CAN_RXM_OFFSET 0x080U
#define PIC32_CAN_RXM_COUNT 4U
#define PIC32_CAN_RXM_STRIDE 0x010U
#define PIC32_CAN_RXM_FIRST 0U
#define PIC32_CAN_RXM_RESET UINT32_C(0x00000000)
#define PIC32_CAN_RXM_RESET_MASK UINT32_C(0xFFFFFFFF)
/* SID: Bits of the standard identifier that are compared. Access rw:configuration. A write has an effect only if
 * configuration (CON.OPMOD == configuration).
 * Contradictions of the manual: example_34_10_mask.
 */
#define PIC32_CAN_RXM_SID_Pos 21U
#define PIC32_CAN_RXM_SID_Msk UINT32_C(0xFFE00000)
#define PIC32_CAN_RXM_SID_Width 11U
#define PIC32_CAN_RXM_SID_Access "rw:configuration"
#define PIC32_CAN_RXM_SID_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RXM_SID_Pos) & PIC32_CAN_RXM_SID_Msk))
static inline uint32_t pic32_can_rxm_sid_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RXM_SID_Msk) >> PIC32_CAN_RXM_SID_Pos);
}
static inline uint32_t pic32_can_rxm_sid_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 2047U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RXM_SID_Msk) | PIC32_CAN_RXM_SID_SET(value));
}
/* MIDE: Whether the type of the message (standard or extended) is compared too. Access rw:configuration. A write
 * has an effect only if configuration (CON.OPMOD == configuration).
 * Contradictions of the manual: identifier_section_names.
 * Register 34-9 p.26; Table 34-3
 */
#define PIC32_CAN_RXM_MIDE_Pos 19U
#define PIC32_CAN_RXM_MIDE_Msk UINT32_C(0x00080000)
#define PIC32_CAN_RXM_MIDE_Width 1U
#define PIC32_CAN_RXM_MIDE_Access "rw:configuration"
#define PIC32_CAN_RXM_MIDE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RXM_MIDE_Pos) & PIC32_CAN_RXM_MIDE_Msk))
static inline uint32_t pic32_can_rxm_mide_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RXM_MIDE_Msk) >> PIC32_CAN_RXM_MIDE_Pos);
}
static inline uint32_t pic32_can_rxm_mide_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RXM_MIDE_Msk) | PIC32_CAN_RXM_MIDE_SET(value));
}
/* EID: Bits of the extended identifier that are compared. Access rw:configuration. A write has an effect only if
 * configuration (CON.OPMOD == configuration).
 */
#define PIC32_CAN_RXM_EID_Pos 0U
#define PIC32_CAN_RXM_EID_Msk UINT32_C(0x0003FFFF)
#define PIC32_CAN_RXM_EID_Width 18U
#define PIC32_CAN_RXM_EID_Access "rw:configuration"
#define PIC32_CAN_RXM_EID_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RXM_EID_Pos) & PIC32_CAN_RXM_EID_Msk))
static inline uint32_t pic32_can_rxm_eid_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RXM_EID_Msk) >> PIC32_CAN_RXM_EID_Pos);
}
static inline uint32_t pic32_can_rxm_eid_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= UINT32_C(262143));
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RXM_EID_Msk) | PIC32_CAN_RXM_EID_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint32_t *pic32_can_rxm(pic32_can_regs_t *regs, unsigned int n)
{
    PIC32_CAN_ASSERT(n < 4U);
    return &regs->RXM[n].RXM;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void pic32_can_rxm_modify(pic32_can_regs_t *regs, unsigned int n, uint32_t clear, uint32_t set)
{
    PIC32_CAN_ASSERT(n < 4U);
    uint32_t value = regs->RXM[n].RXM;
    regs->RXM[n].RXM = (uint32_t)((value & (uint32_t)~clear) | set);
}
/* Clears the given bits: one store to the CLR register. */
static inline void pic32_can_rxm_clr(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 4U);
    regs->RXM[n].RXMCLR = bits;
}
/* Sets the given bits: one store to the SET register. */
static inline void pic32_can_rxm_set(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 4U);
    regs->RXM[n].RXMSET = bits;
}
/* Inverts the given bits: one store to the INV register. */
static inline void pic32_can_rxm_inv(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 4U);
    regs->RXM[n].RXMINV = bits;
}

/* FLTCON: CAN Filter Control Register.
 * Enable, mask and FIFO of the filters, four filters to a register.
 * Hazard: A filter that is switched off while a message is being filtered keeps FLTEN = 1 until that is done;
 * poll FLTEN before changing MSEL, FSEL or CiRXFn. Meanwhile a read-modify-write for another filter writes the 1
 * back.
 * Contradictions of the manual: fltcon1inv_name, filter_control_registers, filter_write_modes.
 * Register 34-10 p.27; Table 34-1 p.12 (offset)
 */
#define PIC32_CAN_FLT_CON_OFFSET 0x0C0U
#define PIC32_CAN_FLT_CON_COUNT 8U
#define PIC32_CAN_FLT_CON_STRIDE 0x010U
#define PIC32_CAN_FLT_CON_FIRST 0U
#define PIC32_CAN_FLT_CON_RESET UINT32_C(0x00000000)
#define PIC32_CAN_FLT_CON_RESET_MASK UINT32_C(0xFFFFFFFF)
/* FLTEN: Enables the filter. After a 0 is written it still reads 1 until the message at hand has been filtered.
 * Access rw. Lane 0 is number 0 in the first register.
 * Contradictions of the manual: filter_enable_note.
 * Register 34-10 p.27; §34.8.1 p.75
 */
#define PIC32_CAN_FLT_CON_FLTEN_Pos(lane) (7U + 8U * (lane))
#define PIC32_CAN_FLT_CON_FLTEN_Msk(lane) ((uint32_t)(UINT32_C(0x00000080) << (8U * (lane))))
#define PIC32_CAN_FLT_CON_FLTEN_Lanes 4U
#define PIC32_CAN_FLT_CON_FLTEN_Width 1U
#define PIC32_CAN_FLT_CON_FLTEN_Access "rw"
#define PIC32_CAN_FLT_CON_FLTEN_SET(lane, value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FLT_CON_FLTEN_Pos(lane)) & PIC32_CAN_FLT_CON_FLTEN_Msk(lane)))
static inline uint32_t pic32_can_flt_con_flten_get(uint32_t reg, unsigned int lane)
{
    PIC32_CAN_ASSERT(lane < 4U);
    return (uint32_t)((reg & PIC32_CAN_FLT_CON_FLTEN_Msk(lane)) >> PIC32_CAN_FLT_CON_FLTEN_Pos(lane));
}
static inline uint32_t pic32_can_flt_con_flten_set(uint32_t reg, unsigned int lane, uint32_t value)
{
    PIC32_CAN_ASSERT(lane < 4U);
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FLT_CON_FLTEN_Msk(lane)) | PIC32_CAN_FLT_CON_FLTEN_SET(lane, value));
}
/* MSEL: Mask that the filter uses. Access rw:filter_off. A write has an effect only if filter_off
 * (!FLTCON.FLTEN[n]). Lane 0 is number 0 in the first register.
 * Contradictions of the manual: filter_enable_note.
 */
#define PIC32_CAN_FLT_CON_MSEL_Pos(lane) (5U + 8U * (lane))
#define PIC32_CAN_FLT_CON_MSEL_Msk(lane) ((uint32_t)(UINT32_C(0x00000060) << (8U * (lane))))
#define PIC32_CAN_FLT_CON_MSEL_Lanes 4U
#define PIC32_CAN_FLT_CON_MSEL_Width 2U
#define PIC32_CAN_FLT_CON_MSEL_Access "rw:filter_off"
#define PIC32_CAN_FLT_CON_MSEL_SET(lane, value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FLT_CON_MSEL_Pos(lane)) & PIC32_CAN_FLT_CON_MSEL_Msk(lane)))
static inline uint32_t pic32_can_flt_con_msel_get(uint32_t reg, unsigned int lane)
{
    PIC32_CAN_ASSERT(lane < 4U);
    return (uint32_t)((reg & PIC32_CAN_FLT_CON_MSEL_Msk(lane)) >> PIC32_CAN_FLT_CON_MSEL_Pos(lane));
}
static inline uint32_t pic32_can_flt_con_msel_set(uint32_t reg, unsigned int lane, uint32_t value)
{
    PIC32_CAN_ASSERT(lane < 4U);
    PIC32_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FLT_CON_MSEL_Msk(lane)) | PIC32_CAN_FLT_CON_MSEL_SET(lane, value));
}
/* FSEL: FIFO that takes the messages the filter accepts. For automatic replies to remote frames it is a transmit
 * FIFO with RTREN set. Access rw:filter_off. A write has an effect only if filter_off (!FLTCON.FLTEN[n]). Lane 0
 * is number 0 in the first register.
 * Contradictions of the manual: filter_enable_note, figure_34_23.
 * Register 34-10 p.27; §34.8.4 p.76; §34.7.5
 */
#define PIC32_CAN_FLT_CON_FSEL_Pos(lane) (0U + 8U * (lane))
#define PIC32_CAN_FLT_CON_FSEL_Msk(lane) ((uint32_t)(UINT32_C(0x0000001F) << (8U * (lane))))
#define PIC32_CAN_FLT_CON_FSEL_Lanes 4U
#define PIC32_CAN_FLT_CON_FSEL_Width 5U
#define PIC32_CAN_FLT_CON_FSEL_Access "rw:filter_off"
#define PIC32_CAN_FLT_CON_FSEL_SET(lane, value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FLT_CON_FSEL_Pos(lane)) & PIC32_CAN_FLT_CON_FSEL_Msk(lane)))
static inline uint32_t pic32_can_flt_con_fsel_get(uint32_t reg, unsigned int lane)
{
    PIC32_CAN_ASSERT(lane < 4U);
    return (uint32_t)((reg & PIC32_CAN_FLT_CON_FSEL_Msk(lane)) >> PIC32_CAN_FLT_CON_FSEL_Pos(lane));
}
static inline uint32_t pic32_can_flt_con_fsel_set(uint32_t reg, unsigned int lane, uint32_t value)
{
    PIC32_CAN_ASSERT(lane < 4U);
    PIC32_CAN_ASSERT(value <= 31U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FLT_CON_FSEL_Msk(lane)) | PIC32_CAN_FLT_CON_FSEL_SET(lane, value));
}
/* The register with the manual's number n. */
static inline volatile uint32_t *pic32_can_flt_con(pic32_can_regs_t *regs, unsigned int n)
{
    PIC32_CAN_ASSERT(n < 8U);
    return &regs->FLTCON[n].FLTCON;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void pic32_can_flt_con_modify(pic32_can_regs_t *regs, unsigned int n, uint32_t clear, uint32_t set)
{
    PIC32_CAN_ASSERT(n < 8U);
    uint32_t value = regs->FLTCON[n].FLTCON;
    regs->FLTCON[n].FLTCON = (uint32_t)((value & (uint32_t)~clear) | set);
}
/* Clears the given bits: one store to the CLR register. */
static inline void pic32_can_flt_con_clr(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 8U);
    regs->FLTCON[n].FLTCONCLR = bits;
}
/* Sets the given bits: one store to the SET register. */
static inline void pic32_can_flt_con_set(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 8U);
    regs->FLTCON[n].FLTCONSET = bits;
}
/* Inverts the given bits: one store to the INV register. */
static inline void pic32_can_flt_con_inv(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 8U);
    regs->FLTCON[n].FLTCONINV = bits;
}

/* RXF: CAN Acceptance Filter Register.
 * Identifier that a message must have to be accepted, where the mask compares it.
 * Contradictions of the manual: register_summary_columns, identifier_section_names, filter_write_modes,
 * example_34_12_identifier.
 * Register 34-18 p.43; Table 34-1 p.12 (offset); Table 34-1 p.12 (stride); external: device_addresses (stride)
 */
#define PIC32_CAN_RXF_OFFSET 0x140U
#define PIC32_CAN_RXF_COUNT 32U
#define PIC32_CAN_RXF_STRIDE 0x010U
#define PIC32_CAN_RXF_FIRST 0U
#define PIC32_CAN_RXF_RESET UINT32_C(0x00000000)
#define PIC32_CAN_RXF_RESET_MASK UINT32_C(0x001C0000)
/* SID: Standard identifier to match. Access rw:filter_off. A write has an effect only if filter_off
 * (!FLTCON.FLTEN[n]).
 * Contradictions of the manual: rxf_bit_labels.
 */
#define PIC32_CAN_RXF_SID_Pos 21U
#define PIC32_CAN_RXF_SID_Msk UINT32_C(0xFFE00000)
#define PIC32_CAN_RXF_SID_Width 11U
#define PIC32_CAN_RXF_SID_Access "rw:filter_off"
#define PIC32_CAN_RXF_SID_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RXF_SID_Pos) & PIC32_CAN_RXF_SID_Msk))
static inline uint32_t pic32_can_rxf_sid_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RXF_SID_Msk) >> PIC32_CAN_RXF_SID_Pos);
}
static inline uint32_t pic32_can_rxf_sid_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 2047U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RXF_SID_Msk) | PIC32_CAN_RXF_SID_SET(value));
}
/* EXID: Type of message that the filter accepts. Only looked at if MIDE of the mask is 1. Access rw:filter_off.
 * A write has an effect only if filter_off (!FLTCON.FLTEN[n]).
 * Contradictions of the manual: identifier_section_names.
 * Register 34-18 p.43; Table 34-3
 */
#define PIC32_CAN_RXF_EXID_Pos 19U
#define PIC32_CAN_RXF_EXID_Msk UINT32_C(0x00080000)
#define PIC32_CAN_RXF_EXID_Width 1U
#define PIC32_CAN_RXF_EXID_Access "rw:filter_off"
#define PIC32_CAN_RXF_EXID_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RXF_EXID_Pos) & PIC32_CAN_RXF_EXID_Msk))
static inline uint32_t pic32_can_rxf_exid_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RXF_EXID_Msk) >> PIC32_CAN_RXF_EXID_Pos);
}
static inline uint32_t pic32_can_rxf_exid_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RXF_EXID_Msk) | PIC32_CAN_RXF_EXID_SET(value));
}
/* EID: Extended identifier to match. With DeviceNet filtering, the data bits to match. Access rw:filter_off. A
 * write has an effect only if filter_off (!FLTCON.FLTEN[n]).
 * Contradictions of the manual: devicenet_bit_order.
 * Register 34-18 p.43; §34.8.7 p.78
 */
#define PIC32_CAN_RXF_EID_Pos 0U
#define PIC32_CAN_RXF_EID_Msk UINT32_C(0x0003FFFF)
#define PIC32_CAN_RXF_EID_Width 18U
#define PIC32_CAN_RXF_EID_Access "rw:filter_off"
#define PIC32_CAN_RXF_EID_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RXF_EID_Pos) & PIC32_CAN_RXF_EID_Msk))
static inline uint32_t pic32_can_rxf_eid_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RXF_EID_Msk) >> PIC32_CAN_RXF_EID_Pos);
}
static inline uint32_t pic32_can_rxf_eid_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= UINT32_C(262143));
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RXF_EID_Msk) | PIC32_CAN_RXF_EID_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint32_t *pic32_can_rxf(pic32_can_regs_t *regs, unsigned int n)
{
    PIC32_CAN_ASSERT(n < 32U);
    return &regs->RXF[n].RXF;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void pic32_can_rxf_modify(pic32_can_regs_t *regs, unsigned int n, uint32_t clear, uint32_t set)
{
    PIC32_CAN_ASSERT(n < 32U);
    uint32_t value = regs->RXF[n].RXF;
    regs->RXF[n].RXF = (uint32_t)((value & (uint32_t)~clear) | set);
}
/* Clears the given bits: one store to the CLR register. */
static inline void pic32_can_rxf_clr(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 32U);
    regs->RXF[n].RXFCLR = bits;
}
/* Sets the given bits: one store to the SET register. */
static inline void pic32_can_rxf_set(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 32U);
    regs->RXF[n].RXFSET = bits;
}
/* Inverts the given bits: one store to the INV register. */
static inline void pic32_can_rxf_inv(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 32U);
    regs->RXF[n].RXFINV = bits;
}

/* FIFOBA: CAN Message Buffer Base Address Register.
 * Physical address of the first message buffer of FIFO0. The buffers of all FIFOs follow from there without
 * gaps.
 * Hazard: The address is physical, not the virtual one a pointer holds; convert it first.
 * Hazard: An address the module cannot use is reported only later, as a fatal system error (SERRIF).
 * A write is dangerous: The module reads and writes memory from this physical address on. The memory for the
 * buffers of all configured FIFOs, and of every FIFO with a lower number, must belong to the module for as long
 * as it is in any mode but Configuration, in the sizes that FSIZE, TXEN and DONLY then have.
 * Contradictions of the manual: fifoba_name, figure_34_9_fifo3.
 * Register 34-19 p.44; Table 34-1 p.12 (offset)
 */
#define PIC32_CAN_FIFO_BA_OFFSET 0x340U
#define PIC32_CAN_FIFO_BA_RESET UINT32_C(0x00000000)
#define PIC32_CAN_FIFO_BA_RESET_MASK UINT32_C(0xFFFFFFFF)
/* CiFIFOBA: Bits 31:2 of the base address. Bits 1:0 of the register are not implemented and read 0, so the
 * buffers are aligned to words. Access rw:configuration. A write has an effect only if configuration (CON.OPMOD
 * == configuration). Means value * 4 bytes.
 * Contradictions of the manual: address_alignment.
 */
#define PIC32_CAN_FIFO_BA_FIFOBA_Pos 2U
#define PIC32_CAN_FIFO_BA_FIFOBA_Msk UINT32_C(0xFFFFFFFC)
#define PIC32_CAN_FIFO_BA_FIFOBA_Width 30U
#define PIC32_CAN_FIFO_BA_FIFOBA_Access "rw:configuration"
#define PIC32_CAN_FIFO_BA_FIFOBA_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_BA_FIFOBA_Pos) & PIC32_CAN_FIFO_BA_FIFOBA_Msk))
static inline uint32_t pic32_can_fifo_ba_fifoba_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_BA_FIFOBA_Msk) >> PIC32_CAN_FIFO_BA_FIFOBA_Pos);
}
static inline uint32_t pic32_can_fifo_ba_fifoba_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= UINT32_C(1073741823));
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_BA_FIFOBA_Msk) | PIC32_CAN_FIFO_BA_FIFOBA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void pic32_can_fifo_ba_modify(pic32_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->FIFOBA;
    regs->FIFOBA = (uint32_t)((value & (uint32_t)~clear) | set);
}
/* Clears the given bits: one store to the CLR register. */
static inline void pic32_can_fifo_ba_clr(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->FIFOBACLR = bits;
}
/* Sets the given bits: one store to the SET register. */
static inline void pic32_can_fifo_ba_set(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->FIFOBASET = bits;
}
/* Inverts the given bits: one store to the INV register. */
static inline void pic32_can_fifo_ba_inv(pic32_can_regs_t *regs, uint32_t bits)
{
    regs->FIFOBAINV = bits;
}

/* FIFOCON: CAN FIFO Control Register.
 * Size, direction, priority and transmit control of the FIFO.
 * Hazard: Every read of this register clears TXLARB and TXERR, the read of a read-modify-write and of a debugger
 * included.
 * Hazard: Writing back what was read can repeat a transmit request that hardware has just withdrawn, or abort
 * one that a remote frame has just made. Use CiFIFOCONnSET for UINC, TXREQ and FRESET and CiFIFOCONnCLR to
 * abort.
 * Hazard: FSIZE, TXEN and DONLY determine where the buffers of all FIFOs with a higher number lie, and how much
 * memory the module uses; see the contract of CiFIFOBA.
 * Contradictions of the manual: fifo_stride, example_34_8_fifo.
 * Register 34-20 p.45; Table 34-1 p.12 (offset)
 */
#define PIC32_CAN_FIFO_CON_OFFSET 0x350U
#define PIC32_CAN_FIFO_CON_COUNT 32U
#define PIC32_CAN_FIFO_CON_STRIDE 0x040U
#define PIC32_CAN_FIFO_CON_FIRST 0U
#define PIC32_CAN_FIFO_CON_RESET UINT32_C(0x00000000)
#define PIC32_CAN_FIFO_CON_RESET_MASK UINT32_C(0xFFFFFFFF)
/* FSIZE: Depth of the FIFO in messages, 1 to 32; the programmed number is one less. Access rw:configuration. A
 * write has an effect only if configuration (CON.OPMOD == configuration). Means value + 1 elements.
 * Contradictions of the manual: figure_34_9_fifo3, fsize_of_four_buffers, figure_34_16.
 */
#define PIC32_CAN_FIFO_CON_FSIZE_Pos 16U
#define PIC32_CAN_FIFO_CON_FSIZE_Msk UINT32_C(0x001F0000)
#define PIC32_CAN_FIFO_CON_FSIZE_Width 5U
#define PIC32_CAN_FIFO_CON_FSIZE_Access "rw:configuration"
#define PIC32_CAN_FIFO_CON_FSIZE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_CON_FSIZE_Pos) & PIC32_CAN_FIFO_CON_FSIZE_Msk))
static inline uint32_t pic32_can_fifo_con_fsize_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CON_FSIZE_Msk) >> PIC32_CAN_FIFO_CON_FSIZE_Pos);
}
static inline uint32_t pic32_can_fifo_con_fsize_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 31U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_CON_FSIZE_Msk) | PIC32_CAN_FIFO_CON_FSIZE_SET(value));
}
/* FRESET: Set to reset the FIFO; hardware clears it when that is done, and nothing else should be done with the
 * FIFO before. No transmission may be pending in a transmit FIFO, and no enabled filter may point to a receive
 * FIFO. Access w1s. A request: writing 1 makes it, writing 0 does nothing, hardware clears it.
 * Contradictions of the manual: command_bits_drawn_writable, fifo_reset_txreq.
 * Register 34-20 p.45; §34.6.4 p.61
 */
#define PIC32_CAN_FIFO_CON_FRESET_Pos 14U
#define PIC32_CAN_FIFO_CON_FRESET_Msk UINT32_C(0x00004000)
#define PIC32_CAN_FIFO_CON_FRESET_Width 1U
#define PIC32_CAN_FIFO_CON_FRESET_Access "w1s"
static inline uint32_t pic32_can_fifo_con_freset_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CON_FRESET_Msk) >> PIC32_CAN_FIFO_CON_FRESET_Pos);
}
/* UINC: Set to advance the software's side of the FIFO by one message: the head of a transmit FIFO after loading
 * a message, the tail of a receive FIFO after reading one. Access w1s. A request: writing 1 makes it, writing 0
 * does nothing, hardware clears it.
 * Contradictions of the manual: command_bits_drawn_writable, example_34_4_fifo, step_lists.
 * Register 34-20 p.46; §34.6.2 p.59; §34.6.3 p.60
 */
#define PIC32_CAN_FIFO_CON_UINC_Pos 13U
#define PIC32_CAN_FIFO_CON_UINC_Msk UINT32_C(0x00002000)
#define PIC32_CAN_FIFO_CON_UINC_Width 1U
#define PIC32_CAN_FIFO_CON_UINC_Access "w1s"
static inline uint32_t pic32_can_fifo_con_uinc_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CON_UINC_Msk) >> PIC32_CAN_FIFO_CON_UINC_Pos);
}
/* DONLY: What is stored of a received message. Without effect on a transmit FIFO. Access rw:configuration. A
 * write has an effect only if configuration (CON.OPMOD == configuration).
 * Contradictions of the manual: donly_name.
 * Register 34-20 p.46; §34.9.1 p.84
 */
#define PIC32_CAN_FIFO_CON_DONLY_Pos 12U
#define PIC32_CAN_FIFO_CON_DONLY_Msk UINT32_C(0x00001000)
#define PIC32_CAN_FIFO_CON_DONLY_Width 1U
#define PIC32_CAN_FIFO_CON_DONLY_Access "rw:configuration"
#define PIC32_CAN_FIFO_CON_DONLY_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_CON_DONLY_Pos) & PIC32_CAN_FIFO_CON_DONLY_Msk))
static inline uint32_t pic32_can_fifo_con_donly_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CON_DONLY_Msk) >> PIC32_CAN_FIFO_CON_DONLY_Pos);
}
static inline uint32_t pic32_can_fifo_con_donly_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_CON_DONLY_Msk) | PIC32_CAN_FIFO_CON_DONLY_SET(value));
}
/* TXEN: Direction of the FIFO. Not protected by Configuration mode. Access rw.
 * Contradictions of the manual: figure_34_16.
 * Register 34-20 p.46
 */
#define PIC32_CAN_FIFO_CON_TXEN_Pos 7U
#define PIC32_CAN_FIFO_CON_TXEN_Msk UINT32_C(0x00000080)
#define PIC32_CAN_FIFO_CON_TXEN_Width 1U
#define PIC32_CAN_FIFO_CON_TXEN_Access "rw"
#define PIC32_CAN_FIFO_CON_TXEN_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_CON_TXEN_Pos) & PIC32_CAN_FIFO_CON_TXEN_Msk))
static inline uint32_t pic32_can_fifo_con_txen_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CON_TXEN_Msk) >> PIC32_CAN_FIFO_CON_TXEN_Pos);
}
static inline uint32_t pic32_can_fifo_con_txen_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_CON_TXEN_Msk) | PIC32_CAN_FIFO_CON_TXEN_SET(value));
}
/* TXABAT: 1 if the last message was aborted, 0 if it completed. Updated when a message completes or is aborted,
 * and by a reset of the FIFO. Access ro.
 * Contradictions of the manual: txabt, transmit_status_drawn_writable.
 * Register 34-20 p.46
 */
#define PIC32_CAN_FIFO_CON_TXABAT_Pos 6U
#define PIC32_CAN_FIFO_CON_TXABAT_Msk UINT32_C(0x00000040)
#define PIC32_CAN_FIFO_CON_TXABAT_Width 1U
#define PIC32_CAN_FIFO_CON_TXABAT_Access "ro"
static inline uint32_t pic32_can_fifo_con_txabat_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CON_TXABAT_Msk) >> PIC32_CAN_FIFO_CON_TXABAT_Pos);
}
/* TXLARB: The message lost arbitration while it was being sent. Cleared by any read of this register and by a
 * reset of the FIFO. Access ro+rc. A read of the register clears it.
 * Contradictions of the manual: transmit_status_drawn_writable.
 * Register 34-20 p.46
 */
#define PIC32_CAN_FIFO_CON_TXLARB_Pos 5U
#define PIC32_CAN_FIFO_CON_TXLARB_Msk UINT32_C(0x00000020)
#define PIC32_CAN_FIFO_CON_TXLARB_Width 1U
#define PIC32_CAN_FIFO_CON_TXLARB_Access "ro+rc"
static inline uint32_t pic32_can_fifo_con_txlarb_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CON_TXLARB_Msk) >> PIC32_CAN_FIFO_CON_TXLARB_Pos);
}
/* TXERR: Transmission was disturbed by a bus error. Cleared by any read of this register and by a reset of the
 * FIFO. Access ro+rc. A read of the register clears it.
 * Contradictions of the manual: transmit_status_drawn_writable.
 * Register 34-20 p.46
 */
#define PIC32_CAN_FIFO_CON_TXERR_Pos 4U
#define PIC32_CAN_FIFO_CON_TXERR_Msk UINT32_C(0x00000010)
#define PIC32_CAN_FIFO_CON_TXERR_Width 1U
#define PIC32_CAN_FIFO_CON_TXERR_Access "ro+rc"
static inline uint32_t pic32_can_fifo_con_txerr_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CON_TXERR_Msk) >> PIC32_CAN_FIFO_CON_TXERR_Pos);
}
/* TXREQ: Set, best after every UINC, to send all messages in the FIFO, also those added meanwhile; hardware
 * clears it when all are sent. Writing 0 while it is 1 asks for an abort, and it stays 1 until the message is
 * aborted or sent. Hardware sets it for a matching remote frame if RTREN is 1. Without effect on a receive FIFO.
 * Access rwhc. A request that can be withdrawn: 1 requests, 0 aborts, hardware clears it.
 * Contradictions of the manual: fifo_reset_txreq, example_34_9_request.
 * Register 34-20 p.46; §34.7.2; §34.7.4; §34.7.5
 */
#define PIC32_CAN_FIFO_CON_TXREQ_Pos 3U
#define PIC32_CAN_FIFO_CON_TXREQ_Msk UINT32_C(0x00000008)
#define PIC32_CAN_FIFO_CON_TXREQ_Width 1U
#define PIC32_CAN_FIFO_CON_TXREQ_Access "rwhc"
#define PIC32_CAN_FIFO_CON_TXREQ_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_CON_TXREQ_Pos) & PIC32_CAN_FIFO_CON_TXREQ_Msk))
static inline uint32_t pic32_can_fifo_con_txreq_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CON_TXREQ_Msk) >> PIC32_CAN_FIFO_CON_TXREQ_Pos);
}
/* RTREN: 1 answers a matching remote frame by setting TXREQ, 0 leaves TXREQ alone. Access rw.
 * Contradictions of the manual: txabt.
 * Register 34-20 p.46; §34.7.5
 */
#define PIC32_CAN_FIFO_CON_RTREN_Pos 2U
#define PIC32_CAN_FIFO_CON_RTREN_Msk UINT32_C(0x00000004)
#define PIC32_CAN_FIFO_CON_RTREN_Width 1U
#define PIC32_CAN_FIFO_CON_RTREN_Access "rw"
#define PIC32_CAN_FIFO_CON_RTREN_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_CON_RTREN_Pos) & PIC32_CAN_FIFO_CON_RTREN_Msk))
static inline uint32_t pic32_can_fifo_con_rtren_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CON_RTREN_Msk) >> PIC32_CAN_FIFO_CON_RTREN_Pos);
}
static inline uint32_t pic32_can_fifo_con_rtren_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_CON_RTREN_Msk) | PIC32_CAN_FIFO_CON_RTREN_SET(value));
}
/* TXPRI: Priority of the FIFO among those ready to send; of equal ones the FIFO with the highest number goes
 * first. Looked at anew before every message, so a change takes effect after the message being sent. Access rw.
 * Contradictions of the manual: txpri_name.
 * Register 34-20 p.46; §34.7.3 p.68
 */
#define PIC32_CAN_FIFO_CON_TXPRI_Pos 0U
#define PIC32_CAN_FIFO_CON_TXPRI_Msk UINT32_C(0x00000003)
#define PIC32_CAN_FIFO_CON_TXPRI_Width 2U
#define PIC32_CAN_FIFO_CON_TXPRI_Access "rw"
#define PIC32_CAN_FIFO_CON_TXPRI_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_CON_TXPRI_Pos) & PIC32_CAN_FIFO_CON_TXPRI_Msk))
static inline uint32_t pic32_can_fifo_con_txpri_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CON_TXPRI_Msk) >> PIC32_CAN_FIFO_CON_TXPRI_Pos);
}
static inline uint32_t pic32_can_fifo_con_txpri_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_CON_TXPRI_Msk) | PIC32_CAN_FIFO_CON_TXPRI_SET(value));
}
/* The register with the manual's number n. */
static inline volatile uint32_t *pic32_can_fifo_con(pic32_can_regs_t *regs, unsigned int n)
{
    PIC32_CAN_ASSERT(n < 32U);
    return &regs->FIFO[n].FIFOCON;
}
/* Clears the given bits: one store to the CLR register. */
static inline void pic32_can_fifo_con_clr(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 32U);
    regs->FIFO[n].FIFOCONCLR = bits;
}
/* Sets the given bits: one store to the SET register. */
static inline void pic32_can_fifo_con_set(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 32U);
    regs->FIFO[n].FIFOCONSET = bits;
}
/* Inverts the given bits: one store to the INV register. */
static inline void pic32_can_fifo_con_inv(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 32U);
    regs->FIFO[n].FIFOCONINV = bits;
}
/* No read-modify-write: the read changes TXLARB, TXERR. Use the functions for single bits above. */

/* FIFOINT: CAN FIFO Interrupt Register.
 * Enables (bits 26:16) and flags (bits 10:0) of the seven interrupts of the FIFO, layer 3.
 * Hazard: Only RXOVFLIF can be cleared by software; do it with CiFIFOINTnCLR, because writing back what was read
 * can clear an overflow that occurred in between. The other flags follow the fill level.
 * Hazard: Setting TXEN raises the three flags of the empty transmit FIFO, so transmit interrupts that are
 * already enabled fire at once.
 * Contradictions of the manual: fifo_stride.
 * Register 34-21 p.47; §34.12.2 p.96; Table 34-1 p.13 (offset)
 */
#define PIC32_CAN_FIFO_INT_OFFSET 0x360U
#define PIC32_CAN_FIFO_INT_COUNT 32U
#define PIC32_CAN_FIFO_INT_STRIDE 0x040U
#define PIC32_CAN_FIFO_INT_FIRST 0U
#define PIC32_CAN_FIFO_INT_RESET UINT32_C(0x00000000)
#define PIC32_CAN_FIFO_INT_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TXNFULLIE: Enables the interrupt for a transmit FIFO that is not full. Access rw. */
#define PIC32_CAN_FIFO_INT_TXNFULLIE_Pos 26U
#define PIC32_CAN_FIFO_INT_TXNFULLIE_Msk UINT32_C(0x04000000)
#define PIC32_CAN_FIFO_INT_TXNFULLIE_Width 1U
#define PIC32_CAN_FIFO_INT_TXNFULLIE_Access "rw"
#define PIC32_CAN_FIFO_INT_TXNFULLIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_INT_TXNFULLIE_Pos) & PIC32_CAN_FIFO_INT_TXNFULLIE_Msk))
static inline uint32_t pic32_can_fifo_int_txnfullie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_TXNFULLIE_Msk) >> PIC32_CAN_FIFO_INT_TXNFULLIE_Pos);
}
static inline uint32_t pic32_can_fifo_int_txnfullie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_INT_TXNFULLIE_Msk) | PIC32_CAN_FIFO_INT_TXNFULLIE_SET(value));
}
/* TXHALFIE: Enables the interrupt for a transmit FIFO that is at most half full. Access rw.
 * Contradictions of the manual: txhalf_name.
 */
#define PIC32_CAN_FIFO_INT_TXHALFIE_Pos 25U
#define PIC32_CAN_FIFO_INT_TXHALFIE_Msk UINT32_C(0x02000000)
#define PIC32_CAN_FIFO_INT_TXHALFIE_Width 1U
#define PIC32_CAN_FIFO_INT_TXHALFIE_Access "rw"
#define PIC32_CAN_FIFO_INT_TXHALFIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_INT_TXHALFIE_Pos) & PIC32_CAN_FIFO_INT_TXHALFIE_Msk))
static inline uint32_t pic32_can_fifo_int_txhalfie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_TXHALFIE_Msk) >> PIC32_CAN_FIFO_INT_TXHALFIE_Pos);
}
static inline uint32_t pic32_can_fifo_int_txhalfie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_INT_TXHALFIE_Msk) | PIC32_CAN_FIFO_INT_TXHALFIE_SET(value));
}
/* TXEMPTYIE: Enables the interrupt for an empty transmit FIFO. Access rw. */
#define PIC32_CAN_FIFO_INT_TXEMPTYIE_Pos 24U
#define PIC32_CAN_FIFO_INT_TXEMPTYIE_Msk UINT32_C(0x01000000)
#define PIC32_CAN_FIFO_INT_TXEMPTYIE_Width 1U
#define PIC32_CAN_FIFO_INT_TXEMPTYIE_Access "rw"
#define PIC32_CAN_FIFO_INT_TXEMPTYIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_INT_TXEMPTYIE_Pos) & PIC32_CAN_FIFO_INT_TXEMPTYIE_Msk))
static inline uint32_t pic32_can_fifo_int_txemptyie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_TXEMPTYIE_Msk) >> PIC32_CAN_FIFO_INT_TXEMPTYIE_Pos);
}
static inline uint32_t pic32_can_fifo_int_txemptyie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_INT_TXEMPTYIE_Msk) | PIC32_CAN_FIFO_INT_TXEMPTYIE_SET(value));
}
/* RXOVFLIE: Enables the overflow interrupt; also lets the overflow through to CiRXOVF. Access rw. */
#define PIC32_CAN_FIFO_INT_RXOVFLIE_Pos 19U
#define PIC32_CAN_FIFO_INT_RXOVFLIE_Msk UINT32_C(0x00080000)
#define PIC32_CAN_FIFO_INT_RXOVFLIE_Width 1U
#define PIC32_CAN_FIFO_INT_RXOVFLIE_Access "rw"
#define PIC32_CAN_FIFO_INT_RXOVFLIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_INT_RXOVFLIE_Pos) & PIC32_CAN_FIFO_INT_RXOVFLIE_Msk))
static inline uint32_t pic32_can_fifo_int_rxovflie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_RXOVFLIE_Msk) >> PIC32_CAN_FIFO_INT_RXOVFLIE_Pos);
}
static inline uint32_t pic32_can_fifo_int_rxovflie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_INT_RXOVFLIE_Msk) | PIC32_CAN_FIFO_INT_RXOVFLIE_SET(value));
}
/* RXFULLIE: Enables the interrupt for a full receive FIFO. Access rw. */
#define PIC32_CAN_FIFO_INT_RXFULLIE_Pos 18U
#define PIC32_CAN_FIFO_INT_RXFULLIE_Msk UINT32_C(0x00040000)
#define PIC32_CAN_FIFO_INT_RXFULLIE_Width 1U
#define PIC32_CAN_FIFO_INT_RXFULLIE_Access "rw"
#define PIC32_CAN_FIFO_INT_RXFULLIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_INT_RXFULLIE_Pos) & PIC32_CAN_FIFO_INT_RXFULLIE_Msk))
static inline uint32_t pic32_can_fifo_int_rxfullie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_RXFULLIE_Msk) >> PIC32_CAN_FIFO_INT_RXFULLIE_Pos);
}
static inline uint32_t pic32_can_fifo_int_rxfullie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_INT_RXFULLIE_Msk) | PIC32_CAN_FIFO_INT_RXFULLIE_SET(value));
}
/* RXHALFIE: Enables the interrupt for a receive FIFO that is at least half full. Access rw.
 * Register 34-21 p.48
 */
#define PIC32_CAN_FIFO_INT_RXHALFIE_Pos 17U
#define PIC32_CAN_FIFO_INT_RXHALFIE_Msk UINT32_C(0x00020000)
#define PIC32_CAN_FIFO_INT_RXHALFIE_Width 1U
#define PIC32_CAN_FIFO_INT_RXHALFIE_Access "rw"
#define PIC32_CAN_FIFO_INT_RXHALFIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_INT_RXHALFIE_Pos) & PIC32_CAN_FIFO_INT_RXHALFIE_Msk))
static inline uint32_t pic32_can_fifo_int_rxhalfie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_RXHALFIE_Msk) >> PIC32_CAN_FIFO_INT_RXHALFIE_Pos);
}
static inline uint32_t pic32_can_fifo_int_rxhalfie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_INT_RXHALFIE_Msk) | PIC32_CAN_FIFO_INT_RXHALFIE_SET(value));
}
/* RXNEMPTYIE: Enables the interrupt for a receive FIFO that is not empty. Access rw.
 * Contradictions of the manual: rxnempty_name.
 * Register 34-21 p.48
 */
#define PIC32_CAN_FIFO_INT_RXNEMPTYIE_Pos 16U
#define PIC32_CAN_FIFO_INT_RXNEMPTYIE_Msk UINT32_C(0x00010000)
#define PIC32_CAN_FIFO_INT_RXNEMPTYIE_Width 1U
#define PIC32_CAN_FIFO_INT_RXNEMPTYIE_Access "rw"
#define PIC32_CAN_FIFO_INT_RXNEMPTYIE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_FIFO_INT_RXNEMPTYIE_Pos) & PIC32_CAN_FIFO_INT_RXNEMPTYIE_Msk))
static inline uint32_t pic32_can_fifo_int_rxnemptyie_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_RXNEMPTYIE_Msk) >> PIC32_CAN_FIFO_INT_RXNEMPTYIE_Pos);
}
static inline uint32_t pic32_can_fifo_int_rxnemptyie_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_FIFO_INT_RXNEMPTYIE_Msk) | PIC32_CAN_FIFO_INT_RXNEMPTYIE_SET(value));
}
/* TXNFULLIF: Transmit FIFO has room for at least one message. Reads 0 for a receive FIFO. Access ro.
 * Register 34-21 p.48
 */
#define PIC32_CAN_FIFO_INT_TXNFULLIF_Pos 10U
#define PIC32_CAN_FIFO_INT_TXNFULLIF_Msk UINT32_C(0x00000400)
#define PIC32_CAN_FIFO_INT_TXNFULLIF_Width 1U
#define PIC32_CAN_FIFO_INT_TXNFULLIF_Access "ro"
static inline uint32_t pic32_can_fifo_int_txnfullif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_TXNFULLIF_Msk) >> PIC32_CAN_FIFO_INT_TXNFULLIF_Pos);
}
/* TXHALFIF: Transmit FIFO is at most half full. Reads 0 for a receive FIFO. Access ro.
 * Contradictions of the manual: txhalf_name, layer3_names.
 * Register 34-21 p.48
 */
#define PIC32_CAN_FIFO_INT_TXHALFIF_Pos 9U
#define PIC32_CAN_FIFO_INT_TXHALFIF_Msk UINT32_C(0x00000200)
#define PIC32_CAN_FIFO_INT_TXHALFIF_Width 1U
#define PIC32_CAN_FIFO_INT_TXHALFIF_Access "ro"
static inline uint32_t pic32_can_fifo_int_txhalfif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_TXHALFIF_Msk) >> PIC32_CAN_FIFO_INT_TXHALFIF_Pos);
}
/* TXEMPTYIF: Transmit FIFO has no message queued. Reads 0 for a receive FIFO. Access ro.
 * Contradictions of the manual: layer3_names.
 * Register 34-21 p.48
 */
#define PIC32_CAN_FIFO_INT_TXEMPTYIF_Pos 8U
#define PIC32_CAN_FIFO_INT_TXEMPTYIF_Msk UINT32_C(0x00000100)
#define PIC32_CAN_FIFO_INT_TXEMPTYIF_Width 1U
#define PIC32_CAN_FIFO_INT_TXEMPTYIF_Access "ro"
static inline uint32_t pic32_can_fifo_int_txemptyif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_TXEMPTYIF_Msk) >> PIC32_CAN_FIFO_INT_TXEMPTYIF_Pos);
}
/* RXOVFLIF: A message for the full receive FIFO was lost, or could not be stored in time. Stays set until
 * cleared. In a transmit FIFO with RTREN set, a remote frame found it empty. Access w0c. A flag: writing 0
 * clears it, writing 1 does nothing.
 * Contradictions of the manual: receive_flag_bits, layer3_names, remote_request_overflow.
 * Register 34-21 p.48; §34.12.3 p.97; §34.12.1.6 p.95; §34.7.5
 */
#define PIC32_CAN_FIFO_INT_RXOVFLIF_Pos 3U
#define PIC32_CAN_FIFO_INT_RXOVFLIF_Msk UINT32_C(0x00000008)
#define PIC32_CAN_FIFO_INT_RXOVFLIF_Width 1U
#define PIC32_CAN_FIFO_INT_RXOVFLIF_Access "w0c"
static inline uint32_t pic32_can_fifo_int_rxovflif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_RXOVFLIF_Msk) >> PIC32_CAN_FIFO_INT_RXOVFLIF_Pos);
}
/* RXFULLIF: Receive FIFO is full. Reads 0 for a transmit FIFO. Access ro.
 * Contradictions of the manual: receive_flag_bits.
 * Register 34-21 p.48
 */
#define PIC32_CAN_FIFO_INT_RXFULLIF_Pos 2U
#define PIC32_CAN_FIFO_INT_RXFULLIF_Msk UINT32_C(0x00000004)
#define PIC32_CAN_FIFO_INT_RXFULLIF_Width 1U
#define PIC32_CAN_FIFO_INT_RXFULLIF_Access "ro"
static inline uint32_t pic32_can_fifo_int_rxfullif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_RXFULLIF_Msk) >> PIC32_CAN_FIFO_INT_RXFULLIF_Pos);
}
/* RXHALFIF: Receive FIFO is at least half full. Reads 0 for a transmit FIFO. Access ro.
 * Contradictions of the manual: receive_flag_bits.
 * Register 34-21 p.49
 */
#define PIC32_CAN_FIFO_INT_RXHALFIF_Pos 1U
#define PIC32_CAN_FIFO_INT_RXHALFIF_Msk UINT32_C(0x00000002)
#define PIC32_CAN_FIFO_INT_RXHALFIF_Width 1U
#define PIC32_CAN_FIFO_INT_RXHALFIF_Access "ro"
static inline uint32_t pic32_can_fifo_int_rxhalfif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_RXHALFIF_Msk) >> PIC32_CAN_FIFO_INT_RXHALFIF_Pos);
}
/* RXNEMPTYIF: Receive FIFO holds at least one message. Reads 0 for a transmit FIFO. Access ro.
 * Contradictions of the manual: receive_flag_bits, rxnempty_name, layer3_names.
 * Register 34-21 p.49
 */
#define PIC32_CAN_FIFO_INT_RXNEMPTYIF_Pos 0U
#define PIC32_CAN_FIFO_INT_RXNEMPTYIF_Msk UINT32_C(0x00000001)
#define PIC32_CAN_FIFO_INT_RXNEMPTYIF_Width 1U
#define PIC32_CAN_FIFO_INT_RXNEMPTYIF_Access "ro"
static inline uint32_t pic32_can_fifo_int_rxnemptyif_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_INT_RXNEMPTYIF_Msk) >> PIC32_CAN_FIFO_INT_RXNEMPTYIF_Pos);
}
/* The register with the manual's number n. */
static inline volatile uint32_t *pic32_can_fifo_int(pic32_can_regs_t *regs, unsigned int n)
{
    PIC32_CAN_ASSERT(n < 32U);
    return &regs->FIFO[n].FIFOINT;
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void pic32_can_fifo_int_modify(pic32_can_regs_t *regs, unsigned int n, uint32_t clear, uint32_t set)
{
    PIC32_CAN_ASSERT(n < 32U);
    uint32_t value = regs->FIFO[n].FIFOINT;
    value = (uint32_t)((value & (uint32_t)~UINT32_C(0x00000707)) | UINT32_C(0x00000008));
    regs->FIFO[n].FIFOINT = (uint32_t)((value & (uint32_t)~clear) | set);
}
/* Clears the given bits: one store to the CLR register. */
static inline void pic32_can_fifo_int_clr(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 32U);
    regs->FIFO[n].FIFOINTCLR = bits;
}
/* Sets the given bits: one store to the SET register. */
static inline void pic32_can_fifo_int_set(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 32U);
    regs->FIFO[n].FIFOINTSET = bits;
}
/* Inverts the given bits: one store to the INV register. */
static inline void pic32_can_fifo_int_inv(pic32_can_regs_t *regs, unsigned int n, uint32_t bits)
{
    PIC32_CAN_ASSERT(n < 32U);
    regs->FIFO[n].FIFOINTINV = bits;
}

/* FIFOUA: CAN FIFO User Address Register.
 * Physical address of the message buffer that software has to use next.
 * Hazard: Not valid in Configuration mode; read it only when OPMOD shows another mode.
 * Hazard: The address is physical; convert it to a virtual address before using it as a pointer.
 * Contradictions of the manual: fifo_stride, fifoua_fifoci_names, seven_digit_address, step_lists.
 * Register 34-22 p.50; §34.6.2 p.59; §34.6.3 p.60; Table 34-1 p.13 (offset)
 */
#define PIC32_CAN_FIFO_UA_OFFSET 0x370U
#define PIC32_CAN_FIFO_UA_COUNT 32U
#define PIC32_CAN_FIFO_UA_STRIDE 0x040U
#define PIC32_CAN_FIFO_UA_FIRST 0U
#define PIC32_CAN_FIFO_UA_RESET UINT32_C(0x00000000)
#define PIC32_CAN_FIFO_UA_RESET_MASK UINT32_C(0x00000003)
/* CiFIFOUA: Byte address where the next message to send is to be stored (head of a transmit FIFO) or the next
 * received message is to be read (tail of a receive FIFO). UINC moves it on by one buffer, 16 bytes or 8 in a
 * data-only FIFO, and wraps it at the end of the FIFO. Bits 1:0 always read 0. Access ro.
 * Contradictions of the manual: address_alignment.
 */
#define PIC32_CAN_FIFO_UA_FIFOUA_Pos 0U
#define PIC32_CAN_FIFO_UA_FIFOUA_Msk UINT32_C(0xFFFFFFFF)
#define PIC32_CAN_FIFO_UA_FIFOUA_Width 32U
#define PIC32_CAN_FIFO_UA_FIFOUA_Access "ro"
static inline uint32_t pic32_can_fifo_ua_fifoua_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_UA_FIFOUA_Msk) >> PIC32_CAN_FIFO_UA_FIFOUA_Pos);
}
/* The register with the manual's number n. */
static inline const volatile uint32_t *pic32_can_fifo_ua(pic32_can_regs_t *regs, unsigned int n)
{
    PIC32_CAN_ASSERT(n < 32U);
    return &regs->FIFO[n].FIFOUA;
}

/* FIFOCI: CAN Module Message Index Register.
 * Index of the message buffer that the module uses next.
 * Contradictions of the manual: fifo_stride, fifoua_fifoci_names.
 * Register 34-23 p.51; Table 34-1 p.13 (offset)
 */
#define PIC32_CAN_FIFO_CI_OFFSET 0x380U
#define PIC32_CAN_FIFO_CI_COUNT 32U
#define PIC32_CAN_FIFO_CI_STRIDE 0x040U
#define PIC32_CAN_FIFO_CI_FIRST 0U
#define PIC32_CAN_FIFO_CI_RESET UINT32_C(0x00000000)
#define PIC32_CAN_FIFO_CI_RESET_MASK UINT32_C(0xFFFFFFFF)
/* CiFIFOCI: Number, within the FIFO, of the message the module will try to send next (transmit FIFO) or of the
 * buffer the next received message goes to (receive FIFO). Access ro.
 */
#define PIC32_CAN_FIFO_CI_FIFOCI_Pos 0U
#define PIC32_CAN_FIFO_CI_FIFOCI_Msk UINT32_C(0x0000001F)
#define PIC32_CAN_FIFO_CI_FIFOCI_Width 5U
#define PIC32_CAN_FIFO_CI_FIFOCI_Access "ro"
static inline uint32_t pic32_can_fifo_ci_fifoci_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_FIFO_CI_FIFOCI_Msk) >> PIC32_CAN_FIFO_CI_FIFOCI_Pos);
}
/* The register with the manual's number n. */
static inline const volatile uint32_t *pic32_can_fifo_ci(pic32_can_regs_t *regs, unsigned int n)
{
    PIC32_CAN_ASSERT(n < 32U);
    return &regs->FIFO[n].FIFOCI;
}

/* TX_BUFFER: Transmit message buffer.
 * Four words that software fills in. Bits that have no field are to be written 0. Lies in system RAM and has no
 * CLR, SET or INV registers.
 * Data byte 0 is the least significant byte of the first word and is sent first. Bytes beyond the length are not
 * sent.
 * Table 34-2 p.62; §34.7.1 p.62
 */
typedef struct {
    volatile uint32_t CMSGSID; /* Standard identifier. */
    volatile uint32_t CMSGEID; /* Extended identifier, type and length of the message. */
    volatile uint32_t PAYLOAD[2];
} pic32_can_tx_buffer_t;
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_tx_buffer_t, CMSGSID) == 0x000U, pic32_can_tx_buffer_at_CMSGSID);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_tx_buffer_t, CMSGEID) == 0x004U, pic32_can_tx_buffer_at_CMSGEID);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_tx_buffer_t, PAYLOAD) == 0x008U, pic32_can_tx_buffer_at_PAYLOAD);
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_tx_buffer_t) == 0x010U, pic32_can_tx_buffer_size);
#define PIC32_CAN_TX_BUFFER_HEADER_BYTES 8U
/* Word CMSGSID of TX_BUFFER: Standard identifier.
 * Has this layout only if FIFOCON.TXEN == transmit.
 * Table 34-2 p.62; §34.7.1 p.62
 */
#define PIC32_CAN_TX_BUFFER_CMSGSID_OFFSET 0x000U
/* SID: Standard identifier; of an extended message, the 11 most significant bits of its identifier. Access rw. */
#define PIC32_CAN_TX_BUFFER_CMSGSID_SID_Pos 0U
#define PIC32_CAN_TX_BUFFER_CMSGSID_SID_Msk UINT32_C(0x000007FF)
#define PIC32_CAN_TX_BUFFER_CMSGSID_SID_Width 11U
#define PIC32_CAN_TX_BUFFER_CMSGSID_SID_Access "rw"
#define PIC32_CAN_TX_BUFFER_CMSGSID_SID_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_TX_BUFFER_CMSGSID_SID_Pos) & PIC32_CAN_TX_BUFFER_CMSGSID_SID_Msk))
static inline uint32_t pic32_can_tx_buffer_cmsgsid_sid_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TX_BUFFER_CMSGSID_SID_Msk) >> PIC32_CAN_TX_BUFFER_CMSGSID_SID_Pos);
}
static inline uint32_t pic32_can_tx_buffer_cmsgsid_sid_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 2047U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_TX_BUFFER_CMSGSID_SID_Msk) | PIC32_CAN_TX_BUFFER_CMSGSID_SID_SET(value));
}
/* Word CMSGEID of TX_BUFFER: Extended identifier, type and length of the message.
 * Has this layout only if FIFOCON.TXEN == transmit.
 * Figure 34-12 p.63
 */
#define PIC32_CAN_TX_BUFFER_CMSGEID_OFFSET 0x004U
/* SRR: Substitute remote request. Has to be 1 in an extended message, does not matter in a standard one. Access
 * rw.
 */
#define PIC32_CAN_TX_BUFFER_CMSGEID_SRR_Pos 29U
#define PIC32_CAN_TX_BUFFER_CMSGEID_SRR_Msk UINT32_C(0x20000000)
#define PIC32_CAN_TX_BUFFER_CMSGEID_SRR_Width 1U
#define PIC32_CAN_TX_BUFFER_CMSGEID_SRR_Access "rw"
#define PIC32_CAN_TX_BUFFER_CMSGEID_SRR_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_TX_BUFFER_CMSGEID_SRR_Pos) & PIC32_CAN_TX_BUFFER_CMSGEID_SRR_Msk))
static inline uint32_t pic32_can_tx_buffer_cmsgeid_srr_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TX_BUFFER_CMSGEID_SRR_Msk) >> PIC32_CAN_TX_BUFFER_CMSGEID_SRR_Pos);
}
static inline uint32_t pic32_can_tx_buffer_cmsgeid_srr_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_TX_BUFFER_CMSGEID_SRR_Msk) | PIC32_CAN_TX_BUFFER_CMSGEID_SRR_SET(value));
}
/* IDE: Whether the message has an extended identifier. Access rw. */
#define PIC32_CAN_TX_BUFFER_CMSGEID_IDE_Pos 28U
#define PIC32_CAN_TX_BUFFER_CMSGEID_IDE_Msk UINT32_C(0x10000000)
#define PIC32_CAN_TX_BUFFER_CMSGEID_IDE_Width 1U
#define PIC32_CAN_TX_BUFFER_CMSGEID_IDE_Access "rw"
#define PIC32_CAN_TX_BUFFER_CMSGEID_IDE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_TX_BUFFER_CMSGEID_IDE_Pos) & PIC32_CAN_TX_BUFFER_CMSGEID_IDE_Msk))
static inline uint32_t pic32_can_tx_buffer_cmsgeid_ide_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TX_BUFFER_CMSGEID_IDE_Msk) >> PIC32_CAN_TX_BUFFER_CMSGEID_IDE_Pos);
}
static inline uint32_t pic32_can_tx_buffer_cmsgeid_ide_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_TX_BUFFER_CMSGEID_IDE_Msk) | PIC32_CAN_TX_BUFFER_CMSGEID_IDE_SET(value));
}
/* EID: Extended part of the identifier. Access rw. */
#define PIC32_CAN_TX_BUFFER_CMSGEID_EID_Pos 10U
#define PIC32_CAN_TX_BUFFER_CMSGEID_EID_Msk UINT32_C(0x0FFFFC00)
#define PIC32_CAN_TX_BUFFER_CMSGEID_EID_Width 18U
#define PIC32_CAN_TX_BUFFER_CMSGEID_EID_Access "rw"
#define PIC32_CAN_TX_BUFFER_CMSGEID_EID_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_TX_BUFFER_CMSGEID_EID_Pos) & PIC32_CAN_TX_BUFFER_CMSGEID_EID_Msk))
static inline uint32_t pic32_can_tx_buffer_cmsgeid_eid_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TX_BUFFER_CMSGEID_EID_Msk) >> PIC32_CAN_TX_BUFFER_CMSGEID_EID_Pos);
}
static inline uint32_t pic32_can_tx_buffer_cmsgeid_eid_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= UINT32_C(262143));
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_TX_BUFFER_CMSGEID_EID_Msk) | PIC32_CAN_TX_BUFFER_CMSGEID_EID_SET(value));
}
/* RTR: Whether the message is a remote transmission request. Access rw. */
#define PIC32_CAN_TX_BUFFER_CMSGEID_RTR_Pos 9U
#define PIC32_CAN_TX_BUFFER_CMSGEID_RTR_Msk UINT32_C(0x00000200)
#define PIC32_CAN_TX_BUFFER_CMSGEID_RTR_Width 1U
#define PIC32_CAN_TX_BUFFER_CMSGEID_RTR_Access "rw"
#define PIC32_CAN_TX_BUFFER_CMSGEID_RTR_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_TX_BUFFER_CMSGEID_RTR_Pos) & PIC32_CAN_TX_BUFFER_CMSGEID_RTR_Msk))
static inline uint32_t pic32_can_tx_buffer_cmsgeid_rtr_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TX_BUFFER_CMSGEID_RTR_Msk) >> PIC32_CAN_TX_BUFFER_CMSGEID_RTR_Pos);
}
static inline uint32_t pic32_can_tx_buffer_cmsgeid_rtr_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_TX_BUFFER_CMSGEID_RTR_Msk) | PIC32_CAN_TX_BUFFER_CMSGEID_RTR_SET(value));
}
/* RB1: Reserved bit 1 of the CAN frame, to be 0. Access rw. Software has to write 0x0. */
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB1_Pos 8U
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB1_Msk UINT32_C(0x00000100)
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB1_Width 1U
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB1_Access "rw"
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB1_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_TX_BUFFER_CMSGEID_RB1_Pos) & PIC32_CAN_TX_BUFFER_CMSGEID_RB1_Msk))
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB1_MustWrite 0U
static inline uint32_t pic32_can_tx_buffer_cmsgeid_rb1_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TX_BUFFER_CMSGEID_RB1_Msk) >> PIC32_CAN_TX_BUFFER_CMSGEID_RB1_Pos);
}
static inline uint32_t pic32_can_tx_buffer_cmsgeid_rb1_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_TX_BUFFER_CMSGEID_RB1_Msk) | PIC32_CAN_TX_BUFFER_CMSGEID_RB1_SET(value));
}
/* RB0: Reserved bit 0 of the CAN frame, to be 0. Access rw. Software has to write 0x0. */
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB0_Pos 4U
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB0_Msk UINT32_C(0x00000010)
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB0_Width 1U
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB0_Access "rw"
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB0_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_TX_BUFFER_CMSGEID_RB0_Pos) & PIC32_CAN_TX_BUFFER_CMSGEID_RB0_Msk))
#define PIC32_CAN_TX_BUFFER_CMSGEID_RB0_MustWrite 0U
static inline uint32_t pic32_can_tx_buffer_cmsgeid_rb0_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TX_BUFFER_CMSGEID_RB0_Msk) >> PIC32_CAN_TX_BUFFER_CMSGEID_RB0_Pos);
}
static inline uint32_t pic32_can_tx_buffer_cmsgeid_rb0_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_TX_BUFFER_CMSGEID_RB0_Msk) | PIC32_CAN_TX_BUFFER_CMSGEID_RB0_SET(value));
}
/* DLC: Number of data bytes to send. Access rw. */
#define PIC32_CAN_TX_BUFFER_CMSGEID_DLC_Pos 0U
#define PIC32_CAN_TX_BUFFER_CMSGEID_DLC_Msk UINT32_C(0x0000000F)
#define PIC32_CAN_TX_BUFFER_CMSGEID_DLC_Width 4U
#define PIC32_CAN_TX_BUFFER_CMSGEID_DLC_Access "rw"
#define PIC32_CAN_TX_BUFFER_CMSGEID_DLC_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_TX_BUFFER_CMSGEID_DLC_Pos) & PIC32_CAN_TX_BUFFER_CMSGEID_DLC_Msk))
static inline uint32_t pic32_can_tx_buffer_cmsgeid_dlc_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_TX_BUFFER_CMSGEID_DLC_Msk) >> PIC32_CAN_TX_BUFFER_CMSGEID_DLC_Pos);
}
static inline uint32_t pic32_can_tx_buffer_cmsgeid_dlc_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_TX_BUFFER_CMSGEID_DLC_Msk) | PIC32_CAN_TX_BUFFER_CMSGEID_DLC_SET(value));
}
#define PIC32_CAN_TX_BUFFER_PAYLOAD_MAX 8U
/* Bytes of an element that is configured for a payload of so many bytes. */
#define PIC32_CAN_TX_BUFFER_BYTES(payload) (8U + (payload))
/* Payload in bytes for a code of the size field; 0 for a code that has none. */
static inline unsigned int pic32_can_tx_buffer_payload_bytes(unsigned int code)
{
    switch (code) {
    case 0U: return 8U;
    default: return 0U;
    }
}
/* Reads the first bytes of the payload, every word once; byte 0 is the lowest of the first word. */
static inline void pic32_can_tx_buffer_read_payload(const pic32_can_tx_buffer_t *element, uint8_t *data, size_t count)
{
    PIC32_CAN_ASSERT(count <= 8U);
    for (size_t at = 0; at < count; at += 4U) {
        const uint32_t word = element->PAYLOAD[at / 4U];
        for (size_t byte = 0; byte < 4U && at + byte < count; ++byte) {
            data[at + byte] = (uint8_t)((word >> (8U * byte)) & 0xFFU);
        }
    }
}
/* Writes the first bytes of the payload, every word once; the rest of the last word becomes 0. */
static inline void pic32_can_tx_buffer_write_payload(pic32_can_tx_buffer_t *element, const uint8_t *data, size_t count)
{
    PIC32_CAN_ASSERT(count <= 8U);
    for (size_t at = 0; at < count; at += 4U) {
        uint32_t word = 0;
        for (size_t byte = 0; byte < 4U && at + byte < count; ++byte) {
            word = (uint32_t)(word | (uint32_t)((uint32_t)data[at + byte] << (8U * byte)));
        }
        element->PAYLOAD[at / 4U] = word;
    }
}
/* ID: 29-bit identifier of an extended message.
 * §34.2.2; external: harmony
 */
static inline uint32_t pic32_can_tx_buffer_id_read(const pic32_can_tx_buffer_t *element)
{
    const uint32_t part0 = element->CMSGEID;
    const uint32_t part1 = element->CMSGSID;
    return ((uint32_t)((part0 & UINT32_C(0x0FFFFC00)) >> 10U) << 0U) | ((uint32_t)((part1 & UINT32_C(0x000007FF)) >> 0U) << 18U);
}
static inline void pic32_can_tx_buffer_id_write(pic32_can_tx_buffer_t *element, uint32_t value)
{
    element->CMSGEID = (uint32_t)((element->CMSGEID & (uint32_t)~UINT32_C(0x0FFFFC00)) | (uint32_t)(((uint32_t)(value >> 0U) << 10U) & UINT32_C(0x0FFFFC00)));
    element->CMSGSID = (uint32_t)((element->CMSGSID & (uint32_t)~UINT32_C(0x000007FF)) | (uint32_t)(((uint32_t)(value >> 18U) << 0U) & UINT32_C(0x000007FF)));
}

/* RX_BUFFER: Full receive message buffer.
 * Four words that the module stores for a message received into a FIFO with DONLY = 0. Bits that have no field
 * read 0. Lies in system RAM and has no CLR, SET or INV registers.
 * Data byte 0 is the least significant byte of the first word and the first one on the bus. What the bytes
 * beyond the length hold is not stated.
 * Table 34-5 p.80; §34.9 p.80; Example 34-13 p.83
 */
typedef struct {
    volatile uint32_t CMSGSID; /* Time stamp, filter and standard identifier. */
    volatile uint32_t CMSGEID; /* Extended identifier, type and length of the message. */
    volatile uint32_t PAYLOAD[2];
} pic32_can_rx_buffer_t;
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_rx_buffer_t, CMSGSID) == 0x000U, pic32_can_rx_buffer_at_CMSGSID);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_rx_buffer_t, CMSGEID) == 0x004U, pic32_can_rx_buffer_at_CMSGEID);
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_rx_buffer_t, PAYLOAD) == 0x008U, pic32_can_rx_buffer_at_PAYLOAD);
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_rx_buffer_t) == 0x010U, pic32_can_rx_buffer_size);
#define PIC32_CAN_RX_BUFFER_HEADER_BYTES 8U
/* Word CMSGSID of RX_BUFFER: Time stamp, filter and standard identifier.
 * Has this layout only if FIFOCON.TXEN == receive && FIFOCON.DONLY == full_message.
 * Table 34-5 p.80; §34.9 p.80; Example 34-13 p.83
 */
#define PIC32_CAN_RX_BUFFER_CMSGSID_OFFSET 0x000U
/* CMSGTS: Value of CANTS right after the end of frame of the message, if CANCAP is 1. Access rw.
 * Table 34-5 p.80; §34.13 p.98
 */
#define PIC32_CAN_RX_BUFFER_CMSGSID_CMSGTS_Pos 16U
#define PIC32_CAN_RX_BUFFER_CMSGSID_CMSGTS_Msk UINT32_C(0xFFFF0000)
#define PIC32_CAN_RX_BUFFER_CMSGSID_CMSGTS_Width 16U
#define PIC32_CAN_RX_BUFFER_CMSGSID_CMSGTS_Access "rw"
#define PIC32_CAN_RX_BUFFER_CMSGSID_CMSGTS_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RX_BUFFER_CMSGSID_CMSGTS_Pos) & PIC32_CAN_RX_BUFFER_CMSGSID_CMSGTS_Msk))
static inline uint32_t pic32_can_rx_buffer_cmsgsid_cmsgts_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RX_BUFFER_CMSGSID_CMSGTS_Msk) >> PIC32_CAN_RX_BUFFER_CMSGSID_CMSGTS_Pos);
}
static inline uint32_t pic32_can_rx_buffer_cmsgsid_cmsgts_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 65535U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RX_BUFFER_CMSGSID_CMSGTS_Msk) | PIC32_CAN_RX_BUFFER_CMSGSID_CMSGTS_SET(value));
}
/* FILHIT: Filter that accepted the message. Access rw.
 * Table 34-5 p.80; §34.8.4 p.76
 */
#define PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_Pos 11U
#define PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_Msk UINT32_C(0x0000F800)
#define PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_Width 5U
#define PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_Access "rw"
#define PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_Pos) & PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_Msk))
static inline uint32_t pic32_can_rx_buffer_cmsgsid_filhit_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_Msk) >> PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_Pos);
}
static inline uint32_t pic32_can_rx_buffer_cmsgsid_filhit_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 31U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_Msk) | PIC32_CAN_RX_BUFFER_CMSGSID_FILHIT_SET(value));
}
/* SID: Standard identifier; of an extended message, the 11 most significant bits of its identifier. Access rw. */
#define PIC32_CAN_RX_BUFFER_CMSGSID_SID_Pos 0U
#define PIC32_CAN_RX_BUFFER_CMSGSID_SID_Msk UINT32_C(0x000007FF)
#define PIC32_CAN_RX_BUFFER_CMSGSID_SID_Width 11U
#define PIC32_CAN_RX_BUFFER_CMSGSID_SID_Access "rw"
#define PIC32_CAN_RX_BUFFER_CMSGSID_SID_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RX_BUFFER_CMSGSID_SID_Pos) & PIC32_CAN_RX_BUFFER_CMSGSID_SID_Msk))
static inline uint32_t pic32_can_rx_buffer_cmsgsid_sid_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RX_BUFFER_CMSGSID_SID_Msk) >> PIC32_CAN_RX_BUFFER_CMSGSID_SID_Pos);
}
static inline uint32_t pic32_can_rx_buffer_cmsgsid_sid_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 2047U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RX_BUFFER_CMSGSID_SID_Msk) | PIC32_CAN_RX_BUFFER_CMSGSID_SID_SET(value));
}
/* Word CMSGEID of RX_BUFFER: Extended identifier, type and length of the message.
 * Has this layout only if FIFOCON.TXEN == receive && FIFOCON.DONLY == full_message.
 * Table 34-5 p.80; §34.9 p.80; Example 34-13 p.83
 */
#define PIC32_CAN_RX_BUFFER_CMSGEID_OFFSET 0x004U
/* SRR: Substitute remote request bit of the message. Access rw. */
#define PIC32_CAN_RX_BUFFER_CMSGEID_SRR_Pos 29U
#define PIC32_CAN_RX_BUFFER_CMSGEID_SRR_Msk UINT32_C(0x20000000)
#define PIC32_CAN_RX_BUFFER_CMSGEID_SRR_Width 1U
#define PIC32_CAN_RX_BUFFER_CMSGEID_SRR_Access "rw"
#define PIC32_CAN_RX_BUFFER_CMSGEID_SRR_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RX_BUFFER_CMSGEID_SRR_Pos) & PIC32_CAN_RX_BUFFER_CMSGEID_SRR_Msk))
static inline uint32_t pic32_can_rx_buffer_cmsgeid_srr_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RX_BUFFER_CMSGEID_SRR_Msk) >> PIC32_CAN_RX_BUFFER_CMSGEID_SRR_Pos);
}
static inline uint32_t pic32_can_rx_buffer_cmsgeid_srr_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RX_BUFFER_CMSGEID_SRR_Msk) | PIC32_CAN_RX_BUFFER_CMSGEID_SRR_SET(value));
}
/* IDE: Whether the message has an extended identifier. Access rw. */
#define PIC32_CAN_RX_BUFFER_CMSGEID_IDE_Pos 28U
#define PIC32_CAN_RX_BUFFER_CMSGEID_IDE_Msk UINT32_C(0x10000000)
#define PIC32_CAN_RX_BUFFER_CMSGEID_IDE_Width 1U
#define PIC32_CAN_RX_BUFFER_CMSGEID_IDE_Access "rw"
#define PIC32_CAN_RX_BUFFER_CMSGEID_IDE_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RX_BUFFER_CMSGEID_IDE_Pos) & PIC32_CAN_RX_BUFFER_CMSGEID_IDE_Msk))
static inline uint32_t pic32_can_rx_buffer_cmsgeid_ide_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RX_BUFFER_CMSGEID_IDE_Msk) >> PIC32_CAN_RX_BUFFER_CMSGEID_IDE_Pos);
}
static inline uint32_t pic32_can_rx_buffer_cmsgeid_ide_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RX_BUFFER_CMSGEID_IDE_Msk) | PIC32_CAN_RX_BUFFER_CMSGEID_IDE_SET(value));
}
/* EID: Extended part of the identifier. Access rw. */
#define PIC32_CAN_RX_BUFFER_CMSGEID_EID_Pos 10U
#define PIC32_CAN_RX_BUFFER_CMSGEID_EID_Msk UINT32_C(0x0FFFFC00)
#define PIC32_CAN_RX_BUFFER_CMSGEID_EID_Width 18U
#define PIC32_CAN_RX_BUFFER_CMSGEID_EID_Access "rw"
#define PIC32_CAN_RX_BUFFER_CMSGEID_EID_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RX_BUFFER_CMSGEID_EID_Pos) & PIC32_CAN_RX_BUFFER_CMSGEID_EID_Msk))
static inline uint32_t pic32_can_rx_buffer_cmsgeid_eid_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RX_BUFFER_CMSGEID_EID_Msk) >> PIC32_CAN_RX_BUFFER_CMSGEID_EID_Pos);
}
static inline uint32_t pic32_can_rx_buffer_cmsgeid_eid_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= UINT32_C(262143));
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RX_BUFFER_CMSGEID_EID_Msk) | PIC32_CAN_RX_BUFFER_CMSGEID_EID_SET(value));
}
/* RTR: Whether the message is a remote transmission request. Access rw. */
#define PIC32_CAN_RX_BUFFER_CMSGEID_RTR_Pos 9U
#define PIC32_CAN_RX_BUFFER_CMSGEID_RTR_Msk UINT32_C(0x00000200)
#define PIC32_CAN_RX_BUFFER_CMSGEID_RTR_Width 1U
#define PIC32_CAN_RX_BUFFER_CMSGEID_RTR_Access "rw"
#define PIC32_CAN_RX_BUFFER_CMSGEID_RTR_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RX_BUFFER_CMSGEID_RTR_Pos) & PIC32_CAN_RX_BUFFER_CMSGEID_RTR_Msk))
static inline uint32_t pic32_can_rx_buffer_cmsgeid_rtr_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RX_BUFFER_CMSGEID_RTR_Msk) >> PIC32_CAN_RX_BUFFER_CMSGEID_RTR_Pos);
}
static inline uint32_t pic32_can_rx_buffer_cmsgeid_rtr_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RX_BUFFER_CMSGEID_RTR_Msk) | PIC32_CAN_RX_BUFFER_CMSGEID_RTR_SET(value));
}
/* RB1: Reserved bit 1 of the CAN frame. Access rw. */
#define PIC32_CAN_RX_BUFFER_CMSGEID_RB1_Pos 8U
#define PIC32_CAN_RX_BUFFER_CMSGEID_RB1_Msk UINT32_C(0x00000100)
#define PIC32_CAN_RX_BUFFER_CMSGEID_RB1_Width 1U
#define PIC32_CAN_RX_BUFFER_CMSGEID_RB1_Access "rw"
#define PIC32_CAN_RX_BUFFER_CMSGEID_RB1_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RX_BUFFER_CMSGEID_RB1_Pos) & PIC32_CAN_RX_BUFFER_CMSGEID_RB1_Msk))
static inline uint32_t pic32_can_rx_buffer_cmsgeid_rb1_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RX_BUFFER_CMSGEID_RB1_Msk) >> PIC32_CAN_RX_BUFFER_CMSGEID_RB1_Pos);
}
static inline uint32_t pic32_can_rx_buffer_cmsgeid_rb1_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RX_BUFFER_CMSGEID_RB1_Msk) | PIC32_CAN_RX_BUFFER_CMSGEID_RB1_SET(value));
}
/* RB0: Reserved bit 0 of the CAN frame. Access rw. */
#define PIC32_CAN_RX_BUFFER_CMSGEID_RB0_Pos 4U
#define PIC32_CAN_RX_BUFFER_CMSGEID_RB0_Msk UINT32_C(0x00000010)
#define PIC32_CAN_RX_BUFFER_CMSGEID_RB0_Width 1U
#define PIC32_CAN_RX_BUFFER_CMSGEID_RB0_Access "rw"
#define PIC32_CAN_RX_BUFFER_CMSGEID_RB0_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RX_BUFFER_CMSGEID_RB0_Pos) & PIC32_CAN_RX_BUFFER_CMSGEID_RB0_Msk))
static inline uint32_t pic32_can_rx_buffer_cmsgeid_rb0_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RX_BUFFER_CMSGEID_RB0_Msk) >> PIC32_CAN_RX_BUFFER_CMSGEID_RB0_Pos);
}
static inline uint32_t pic32_can_rx_buffer_cmsgeid_rb0_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RX_BUFFER_CMSGEID_RB0_Msk) | PIC32_CAN_RX_BUFFER_CMSGEID_RB0_SET(value));
}
/* DLC: Data length code of the message. Access rw. */
#define PIC32_CAN_RX_BUFFER_CMSGEID_DLC_Pos 0U
#define PIC32_CAN_RX_BUFFER_CMSGEID_DLC_Msk UINT32_C(0x0000000F)
#define PIC32_CAN_RX_BUFFER_CMSGEID_DLC_Width 4U
#define PIC32_CAN_RX_BUFFER_CMSGEID_DLC_Access "rw"
#define PIC32_CAN_RX_BUFFER_CMSGEID_DLC_SET(value) ((uint32_t)(((uint32_t)(value) << PIC32_CAN_RX_BUFFER_CMSGEID_DLC_Pos) & PIC32_CAN_RX_BUFFER_CMSGEID_DLC_Msk))
static inline uint32_t pic32_can_rx_buffer_cmsgeid_dlc_get(uint32_t reg)
{
    return (uint32_t)((reg & PIC32_CAN_RX_BUFFER_CMSGEID_DLC_Msk) >> PIC32_CAN_RX_BUFFER_CMSGEID_DLC_Pos);
}
static inline uint32_t pic32_can_rx_buffer_cmsgeid_dlc_set(uint32_t reg, uint32_t value)
{
    PIC32_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~PIC32_CAN_RX_BUFFER_CMSGEID_DLC_Msk) | PIC32_CAN_RX_BUFFER_CMSGEID_DLC_SET(value));
}
#define PIC32_CAN_RX_BUFFER_PAYLOAD_MAX 8U
/* Bytes of an element that is configured for a payload of so many bytes. */
#define PIC32_CAN_RX_BUFFER_BYTES(payload) (8U + (payload))
/* Payload in bytes for a code of the size field; 0 for a code that has none. */
static inline unsigned int pic32_can_rx_buffer_payload_bytes(unsigned int code)
{
    switch (code) {
    case 0U: return 8U;
    default: return 0U;
    }
}
/* Reads the first bytes of the payload, every word once; byte 0 is the lowest of the first word. */
static inline void pic32_can_rx_buffer_read_payload(const pic32_can_rx_buffer_t *element, uint8_t *data, size_t count)
{
    PIC32_CAN_ASSERT(count <= 8U);
    for (size_t at = 0; at < count; at += 4U) {
        const uint32_t word = element->PAYLOAD[at / 4U];
        for (size_t byte = 0; byte < 4U && at + byte < count; ++byte) {
            data[at + byte] = (uint8_t)((word >> (8U * byte)) & 0xFFU);
        }
    }
}
/* Writes the first bytes of the payload, every word once; the rest of the last word becomes 0. */
static inline void pic32_can_rx_buffer_write_payload(pic32_can_rx_buffer_t *element, const uint8_t *data, size_t count)
{
    PIC32_CAN_ASSERT(count <= 8U);
    for (size_t at = 0; at < count; at += 4U) {
        uint32_t word = 0;
        for (size_t byte = 0; byte < 4U && at + byte < count; ++byte) {
            word = (uint32_t)(word | (uint32_t)((uint32_t)data[at + byte] << (8U * byte)));
        }
        element->PAYLOAD[at / 4U] = word;
    }
}
/* ID: 29-bit identifier of an extended message.
 * §34.2.2; external: harmony
 */
static inline uint32_t pic32_can_rx_buffer_id_read(const pic32_can_rx_buffer_t *element)
{
    const uint32_t part0 = element->CMSGEID;
    const uint32_t part1 = element->CMSGSID;
    return ((uint32_t)((part0 & UINT32_C(0x0FFFFC00)) >> 10U) << 0U) | ((uint32_t)((part1 & UINT32_C(0x000007FF)) >> 0U) << 18U);
}
static inline void pic32_can_rx_buffer_id_write(pic32_can_rx_buffer_t *element, uint32_t value)
{
    element->CMSGEID = (uint32_t)((element->CMSGEID & (uint32_t)~UINT32_C(0x0FFFFC00)) | (uint32_t)(((uint32_t)(value >> 0U) << 10U) & UINT32_C(0x0FFFFC00)));
    element->CMSGSID = (uint32_t)((element->CMSGSID & (uint32_t)~UINT32_C(0x000007FF)) | (uint32_t)(((uint32_t)(value >> 18U) << 0U) & UINT32_C(0x000007FF)));
}

/* RX_DATA_BUFFER: Data-only receive message buffer.
 * Two words that the module stores for a message received into a FIFO with TXEN = 0 and DONLY = 1. Identifier,
 * reserved bits, length and time stamp are dropped even if time stamping is on, so neither the length nor the
 * filter can be recovered from it.
 * Always eight bytes; those beyond the length of the message are filled with 0.
 * Table 34-6 p.84; §34.9.1 p.84
 */
typedef struct {
    volatile uint32_t PAYLOAD[2];
} pic32_can_rx_data_buffer_t;
PIC32_CAN_STATIC_ASSERT(offsetof(pic32_can_rx_data_buffer_t, PAYLOAD) == 0x000U, pic32_can_rx_data_buffer_at_PAYLOAD);
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_rx_data_buffer_t) == 0x008U, pic32_can_rx_data_buffer_size);
#define PIC32_CAN_RX_DATA_BUFFER_HEADER_BYTES 0U
#define PIC32_CAN_RX_DATA_BUFFER_PAYLOAD_MAX 8U
/* Bytes of an element that is configured for a payload of so many bytes. */
#define PIC32_CAN_RX_DATA_BUFFER_BYTES(payload) (0U + (payload))
/* Payload in bytes for a code of the size field; 0 for a code that has none. */
static inline unsigned int pic32_can_rx_data_buffer_payload_bytes(unsigned int code)
{
    switch (code) {
    case 0U: return 8U;
    default: return 0U;
    }
}
/* Reads the first bytes of the payload, every word once; byte 0 is the lowest of the first word. */
static inline void pic32_can_rx_data_buffer_read_payload(const pic32_can_rx_data_buffer_t *element, uint8_t *data, size_t count)
{
    PIC32_CAN_ASSERT(count <= 8U);
    for (size_t at = 0; at < count; at += 4U) {
        const uint32_t word = element->PAYLOAD[at / 4U];
        for (size_t byte = 0; byte < 4U && at + byte < count; ++byte) {
            data[at + byte] = (uint8_t)((word >> (8U * byte)) & 0xFFU);
        }
    }
}
/* Writes the first bytes of the payload, every word once; the rest of the last word becomes 0. */
static inline void pic32_can_rx_data_buffer_write_payload(pic32_can_rx_data_buffer_t *element, const uint8_t *data, size_t count)
{
    PIC32_CAN_ASSERT(count <= 8U);
    for (size_t at = 0; at < count; at += 4U) {
        uint32_t word = 0;
        for (size_t byte = 0; byte < 4U && at + byte < count; ++byte) {
            word = (uint32_t)(word | (uint32_t)((uint32_t)data[at + byte] << (8U * byte)));
        }
        element->PAYLOAD[at / 4U] = word;
    }
}

/* CAN1 of PIC32MX575F512L, PIC32MX764F128L, PIC32MX795F512L.
 * The base is the uncached virtual address (KSEG1) of physical address 0x1F88B000. 46 is the interrupt vector;
 * the number of the request, which selects its flag and enable bits in the interrupt controller, is 58. The
 * PIC32MX570F512L has its CAN1 at the same base but with vector 47 and request 77, and chips of its group are
 * said to have only 16 FIFOs and filters.
 * external: device_header (base); external: device_header (interrupts); external: nuttx_irq (interrupts);
 * external: canopennode
 */
#ifndef PIC32_CAN_CAN1_BASE
#define PIC32_CAN_CAN1_BASE UINT32_C(0xBF88B000)
#endif
#define PIC32_CAN_CAN1 ((pic32_can_regs_t *)(uintptr_t)PIC32_CAN_CAN1_BASE)
#define PIC32_CAN_CAN1_CAN_IRQ 46

/* CAN2 of PIC32MX795F512L.
 * The base is the uncached virtual address (KSEG1) of physical address 0x1F88C000. 47 is the interrupt vector,
 * the number of the request is 59. The headers of the PIC32MX575F512L and PIC32MX764F128L have no second CAN
 * module.
 * external: device_header (base); external: device_header (interrupts); external: nuttx_irq (interrupts)
 */
#ifndef PIC32_CAN_CAN2_BASE
#define PIC32_CAN_CAN2_BASE UINT32_C(0xBF88C000)
#endif
#define PIC32_CAN_CAN2 ((pic32_can_regs_t *)(uintptr_t)PIC32_CAN_CAN2_BASE)
#define PIC32_CAN_CAN2_CAN_IRQ 47

/* The manufacturer's names, such as C1CON and C1CONbits, over the same layout.
 * Define PIC32_CAN_MICROCHIP_NAMES before including this header, and PIC32_CAN_C1_BASE, PIC32_CAN_C2_BASE with
 * the base addresses where no default stands below.
 * Containers have fixed width. A register with flags that a bit-field assignment would clear, or with fields
 * that the read changes, has a const view: clear its flags with the functions above.
 */
#ifdef PIC32_CAN_MICROCHIP_NAMES
#if defined(__BYTE_ORDER__) && defined(__ORDER_LITTLE_ENDIAN__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "bit-fields are laid out for little-endian compilers"
#endif
typedef struct {
    uint32_t DNCNT : 5;
    uint32_t : 6;
    uint32_t CANBUSY : 1;
    uint32_t : 1;
    uint32_t SIDLE : 1;
    uint32_t : 1;
    uint32_t ON : 1;
    uint32_t : 4;
    uint32_t CANCAP : 1;
    uint32_t OPMOD : 3;
    uint32_t REQOP : 3;
    uint32_t ABAT : 1;
    uint32_t : 4;
} pic32_can_con_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_con_bits_t) == 4U, pic32_can_con_bits_t_size);
typedef struct {
    uint32_t BRP : 6;
    uint32_t SJW : 2;
    uint32_t PRSEG : 3;
    uint32_t SEG1PH : 3;
    uint32_t SAM : 1;
    uint32_t SEG2PHTS : 1;
    uint32_t SEG2PH : 3;
    uint32_t : 3;
    uint32_t WAKFIL : 1;
    uint32_t : 9;
} pic32_can_cfg_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_cfg_bits_t) == 4U, pic32_can_cfg_bits_t_size);
typedef struct {
    uint32_t TBIF : 1;
    uint32_t RBIF : 1;
    uint32_t CTMRIF : 1;
    uint32_t MODIF : 1;
    uint32_t : 7;
    uint32_t RBOVIF : 1;
    uint32_t SERRIF : 1;
    uint32_t CERRIF : 1;
    uint32_t WAKIF : 1;
    uint32_t IVRIF : 1;
    uint32_t TBIE : 1;
    uint32_t RBIE : 1;
    uint32_t CTMRIE : 1;
    uint32_t MODIE : 1;
    uint32_t : 7;
    uint32_t RBOVIE : 1;
    uint32_t SERRIE : 1;
    uint32_t CERRIE : 1;
    uint32_t WAKIE : 1;
    uint32_t IVRIE : 1;
} pic32_can_int_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_int_bits_t) == 4U, pic32_can_int_bits_t_size);
typedef struct {
    uint32_t ICOD : 7;
    uint32_t : 1;
    uint32_t FILHIT : 5;
    uint32_t : 19;
} pic32_can_vec_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_vec_bits_t) == 4U, pic32_can_vec_bits_t_size);
typedef struct {
    uint32_t REC : 8;
    uint32_t TEC : 8;
    uint32_t EWARN : 1;
    uint32_t RXWARN : 1;
    uint32_t TXWARN : 1;
    uint32_t RXBP : 1;
    uint32_t TXBP : 1;
    uint32_t TXBO : 1;
    uint32_t : 10;
} pic32_can_trec_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_trec_bits_t) == 4U, pic32_can_trec_bits_t_size);
typedef struct {
    uint32_t FIFOIP0 : 1;
    uint32_t FIFOIP1 : 1;
    uint32_t FIFOIP2 : 1;
    uint32_t FIFOIP3 : 1;
    uint32_t FIFOIP4 : 1;
    uint32_t FIFOIP5 : 1;
    uint32_t FIFOIP6 : 1;
    uint32_t FIFOIP7 : 1;
    uint32_t FIFOIP8 : 1;
    uint32_t FIFOIP9 : 1;
    uint32_t FIFOIP10 : 1;
    uint32_t FIFOIP11 : 1;
    uint32_t FIFOIP12 : 1;
    uint32_t FIFOIP13 : 1;
    uint32_t FIFOIP14 : 1;
    uint32_t FIFOIP15 : 1;
    uint32_t FIFOIP16 : 1;
    uint32_t FIFOIP17 : 1;
    uint32_t FIFOIP18 : 1;
    uint32_t FIFOIP19 : 1;
    uint32_t FIFOIP20 : 1;
    uint32_t FIFOIP21 : 1;
    uint32_t FIFOIP22 : 1;
    uint32_t FIFOIP23 : 1;
    uint32_t FIFOIP24 : 1;
    uint32_t FIFOIP25 : 1;
    uint32_t FIFOIP26 : 1;
    uint32_t FIFOIP27 : 1;
    uint32_t FIFOIP28 : 1;
    uint32_t FIFOIP29 : 1;
    uint32_t FIFOIP30 : 1;
    uint32_t FIFOIP31 : 1;
} pic32_can_fstat_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fstat_bits_t) == 4U, pic32_can_fstat_bits_t_size);
typedef struct {
    uint32_t RXOVF0 : 1;
    uint32_t RXOVF1 : 1;
    uint32_t RXOVF2 : 1;
    uint32_t RXOVF3 : 1;
    uint32_t RXOVF4 : 1;
    uint32_t RXOVF5 : 1;
    uint32_t RXOVF6 : 1;
    uint32_t RXOVF7 : 1;
    uint32_t RXOVF8 : 1;
    uint32_t RXOVF9 : 1;
    uint32_t RXOVF10 : 1;
    uint32_t RXOVF11 : 1;
    uint32_t RXOVF12 : 1;
    uint32_t RXOVF13 : 1;
    uint32_t RXOVF14 : 1;
    uint32_t RXOVF15 : 1;
    uint32_t RXOVF16 : 1;
    uint32_t RXOVF17 : 1;
    uint32_t RXOVF18 : 1;
    uint32_t RXOVF19 : 1;
    uint32_t RXOVF20 : 1;
    uint32_t RXOVF21 : 1;
    uint32_t RXOVF22 : 1;
    uint32_t RXOVF23 : 1;
    uint32_t RXOVF24 : 1;
    uint32_t RXOVF25 : 1;
    uint32_t RXOVF26 : 1;
    uint32_t RXOVF27 : 1;
    uint32_t RXOVF28 : 1;
    uint32_t RXOVF29 : 1;
    uint32_t RXOVF30 : 1;
    uint32_t RXOVF31 : 1;
} pic32_can_rxovf_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_rxovf_bits_t) == 4U, pic32_can_rxovf_bits_t_size);
typedef struct {
    uint32_t CANTSPRE : 16;
    uint32_t CANTS : 16;
} pic32_can_tmr_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_tmr_bits_t) == 4U, pic32_can_tmr_bits_t_size);
typedef struct {
    uint32_t EID : 18;
    uint32_t : 1;
    uint32_t MIDE : 1;
    uint32_t : 1;
    uint32_t SID : 11;
} pic32_can_rxm_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_rxm_bits_t) == 4U, pic32_can_rxm_bits_t_size);
typedef struct {
    uint32_t FSEL0 : 5;
    uint32_t MSEL0 : 2;
    uint32_t FLTEN0 : 1;
    uint32_t FSEL1 : 5;
    uint32_t MSEL1 : 2;
    uint32_t FLTEN1 : 1;
    uint32_t FSEL2 : 5;
    uint32_t MSEL2 : 2;
    uint32_t FLTEN2 : 1;
    uint32_t FSEL3 : 5;
    uint32_t MSEL3 : 2;
    uint32_t FLTEN3 : 1;
} pic32_can_fltcon0_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fltcon0_bits_t) == 4U, pic32_can_fltcon0_bits_t_size);
typedef struct {
    uint32_t FSEL4 : 5;
    uint32_t MSEL4 : 2;
    uint32_t FLTEN4 : 1;
    uint32_t FSEL5 : 5;
    uint32_t MSEL5 : 2;
    uint32_t FLTEN5 : 1;
    uint32_t FSEL6 : 5;
    uint32_t MSEL6 : 2;
    uint32_t FLTEN6 : 1;
    uint32_t FSEL7 : 5;
    uint32_t MSEL7 : 2;
    uint32_t FLTEN7 : 1;
} pic32_can_fltcon1_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fltcon1_bits_t) == 4U, pic32_can_fltcon1_bits_t_size);
typedef struct {
    uint32_t FSEL8 : 5;
    uint32_t MSEL8 : 2;
    uint32_t FLTEN8 : 1;
    uint32_t FSEL9 : 5;
    uint32_t MSEL9 : 2;
    uint32_t FLTEN9 : 1;
    uint32_t FSEL10 : 5;
    uint32_t MSEL10 : 2;
    uint32_t FLTEN10 : 1;
    uint32_t FSEL11 : 5;
    uint32_t MSEL11 : 2;
    uint32_t FLTEN11 : 1;
} pic32_can_fltcon2_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fltcon2_bits_t) == 4U, pic32_can_fltcon2_bits_t_size);
typedef struct {
    uint32_t FSEL12 : 5;
    uint32_t MSEL12 : 2;
    uint32_t FLTEN12 : 1;
    uint32_t FSEL13 : 5;
    uint32_t MSEL13 : 2;
    uint32_t FLTEN13 : 1;
    uint32_t FSEL14 : 5;
    uint32_t MSEL14 : 2;
    uint32_t FLTEN14 : 1;
    uint32_t FSEL15 : 5;
    uint32_t MSEL15 : 2;
    uint32_t FLTEN15 : 1;
} pic32_can_fltcon3_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fltcon3_bits_t) == 4U, pic32_can_fltcon3_bits_t_size);
typedef struct {
    uint32_t FSEL16 : 5;
    uint32_t MSEL16 : 2;
    uint32_t FLTEN16 : 1;
    uint32_t FSEL17 : 5;
    uint32_t MSEL17 : 2;
    uint32_t FLTEN17 : 1;
    uint32_t FSEL18 : 5;
    uint32_t MSEL18 : 2;
    uint32_t FLTEN18 : 1;
    uint32_t FSEL19 : 5;
    uint32_t MSEL19 : 2;
    uint32_t FLTEN19 : 1;
} pic32_can_fltcon4_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fltcon4_bits_t) == 4U, pic32_can_fltcon4_bits_t_size);
typedef struct {
    uint32_t FSEL20 : 5;
    uint32_t MSEL20 : 2;
    uint32_t FLTEN20 : 1;
    uint32_t FSEL21 : 5;
    uint32_t MSEL21 : 2;
    uint32_t FLTEN21 : 1;
    uint32_t FSEL22 : 5;
    uint32_t MSEL22 : 2;
    uint32_t FLTEN22 : 1;
    uint32_t FSEL23 : 5;
    uint32_t MSEL23 : 2;
    uint32_t FLTEN23 : 1;
} pic32_can_fltcon5_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fltcon5_bits_t) == 4U, pic32_can_fltcon5_bits_t_size);
typedef struct {
    uint32_t FSEL24 : 5;
    uint32_t MSEL24 : 2;
    uint32_t FLTEN24 : 1;
    uint32_t FSEL25 : 5;
    uint32_t MSEL25 : 2;
    uint32_t FLTEN25 : 1;
    uint32_t FSEL26 : 5;
    uint32_t MSEL26 : 2;
    uint32_t FLTEN26 : 1;
    uint32_t FSEL27 : 5;
    uint32_t MSEL27 : 2;
    uint32_t FLTEN27 : 1;
} pic32_can_fltcon6_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fltcon6_bits_t) == 4U, pic32_can_fltcon6_bits_t_size);
typedef struct {
    uint32_t FSEL28 : 5;
    uint32_t MSEL28 : 2;
    uint32_t FLTEN28 : 1;
    uint32_t FSEL29 : 5;
    uint32_t MSEL29 : 2;
    uint32_t FLTEN29 : 1;
    uint32_t FSEL30 : 5;
    uint32_t MSEL30 : 2;
    uint32_t FLTEN30 : 1;
    uint32_t FSEL31 : 5;
    uint32_t MSEL31 : 2;
    uint32_t FLTEN31 : 1;
} pic32_can_fltcon7_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fltcon7_bits_t) == 4U, pic32_can_fltcon7_bits_t_size);
typedef struct {
    uint32_t EID : 18;
    uint32_t : 1;
    uint32_t EXID : 1;
    uint32_t : 1;
    uint32_t SID : 11;
} pic32_can_rxf_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_rxf_bits_t) == 4U, pic32_can_rxf_bits_t_size);
typedef struct {
    uint32_t : 2;
    uint32_t CiFIFOBA : 30;
} pic32_can_fifo_ba_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fifo_ba_bits_t) == 4U, pic32_can_fifo_ba_bits_t_size);
typedef struct {
    uint32_t TXPRI : 2;
    uint32_t RTREN : 1;
    uint32_t TXREQ : 1;
    uint32_t TXERR : 1;
    uint32_t TXLARB : 1;
    uint32_t TXABAT : 1;
    uint32_t TXEN : 1;
    uint32_t : 4;
    uint32_t DONLY : 1;
    uint32_t UINC : 1;
    uint32_t FRESET : 1;
    uint32_t : 1;
    uint32_t FSIZE : 5;
    uint32_t : 11;
} pic32_can_fifo_con_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fifo_con_bits_t) == 4U, pic32_can_fifo_con_bits_t_size);
typedef struct {
    uint32_t RXNEMPTYIF : 1;
    uint32_t RXHALFIF : 1;
    uint32_t RXFULLIF : 1;
    uint32_t RXOVFLIF : 1;
    uint32_t : 4;
    uint32_t TXEMPTYIF : 1;
    uint32_t TXHALFIF : 1;
    uint32_t TXNFULLIF : 1;
    uint32_t : 5;
    uint32_t RXNEMPTYIE : 1;
    uint32_t RXHALFIE : 1;
    uint32_t RXFULLIE : 1;
    uint32_t RXOVFLIE : 1;
    uint32_t : 4;
    uint32_t TXEMPTYIE : 1;
    uint32_t TXHALFIE : 1;
    uint32_t TXNFULLIE : 1;
    uint32_t : 5;
} pic32_can_fifo_int_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fifo_int_bits_t) == 4U, pic32_can_fifo_int_bits_t_size);
typedef struct {
    uint32_t CiFIFOUA : 32;
} pic32_can_fifo_ua_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fifo_ua_bits_t) == 4U, pic32_can_fifo_ua_bits_t_size);
typedef struct {
    uint32_t CiFIFOCI : 5;
    uint32_t : 27;
} pic32_can_fifo_ci_bits_t;
PIC32_CAN_STATIC_ASSERT(sizeof(pic32_can_fifo_ci_bits_t) == 4U, pic32_can_fifo_ci_bits_t_size);
#ifndef PIC32_CAN_C1_BASE
#define PIC32_CAN_C1_BASE PIC32_CAN_CAN1_BASE
#endif
#ifdef PIC32_CAN_C1_BASE
#define C1CON (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x000U))
#define C1CONbits (*(volatile pic32_can_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x000U))
#define C1CONCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x004U))
#define C1CONSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x008U))
#define C1CONINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x00CU))
#define C1CFG (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x010U))
#define C1CFGbits (*(volatile pic32_can_cfg_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x010U))
#define C1CFGCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x014U))
#define C1CFGSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x018U))
#define C1CFGINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x01CU))
#define C1INT (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x020U))
#define C1INTbits (*(const volatile pic32_can_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x020U))
#define C1INTCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x024U))
#define C1INTSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x028U))
#define C1INTINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x02CU))
#define C1VEC (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x030U))
#define C1VECbits (*(const volatile pic32_can_vec_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x030U))
#define C1VECCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x034U))
#define C1VECSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x038U))
#define C1VECINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x03CU))
#define C1TREC (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x040U))
#define C1TRECbits (*(const volatile pic32_can_trec_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x040U))
#define C1TRECCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x044U))
#define C1TRECSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x048U))
#define C1TRECINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x04CU))
#define C1FSTAT (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x050U))
#define C1FSTATbits (*(const volatile pic32_can_fstat_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x050U))
#define C1FSTATCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x054U))
#define C1FSTATSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x058U))
#define C1FSTATINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x05CU))
#define C1RXOVF (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x060U))
#define C1RXOVFbits (*(const volatile pic32_can_rxovf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x060U))
#define C1RXOVFCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x064U))
#define C1RXOVFSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x068U))
#define C1RXOVFINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x06CU))
#define C1TMR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x070U))
#define C1TMRbits (*(const volatile pic32_can_tmr_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x070U))
#define C1TMRCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x074U))
#define C1TMRSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x078U))
#define C1TMRINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x07CU))
#define C1RXM0 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x080U))
#define C1RXM0bits (*(volatile pic32_can_rxm_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x080U))
#define C1RXM0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x084U))
#define C1RXM0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x088U))
#define C1RXM0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x08CU))
#define C1RXM1 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x090U))
#define C1RXM1bits (*(volatile pic32_can_rxm_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x090U))
#define C1RXM1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x094U))
#define C1RXM1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x098U))
#define C1RXM1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x09CU))
#define C1RXM2 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0A0U))
#define C1RXM2bits (*(volatile pic32_can_rxm_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0A0U))
#define C1RXM2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0A4U))
#define C1RXM2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0A8U))
#define C1RXM2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0ACU))
#define C1RXM3 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0B0U))
#define C1RXM3bits (*(volatile pic32_can_rxm_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0B0U))
#define C1RXM3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0B4U))
#define C1RXM3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0B8U))
#define C1RXM3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0BCU))
#define C1FLTCON0 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0C0U))
#define C1FLTCON0bits (*(volatile pic32_can_fltcon0_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0C0U))
#define C1FLTCON0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0C4U))
#define C1FLTCON0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0C8U))
#define C1FLTCON0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0CCU))
#define C1FLTCON1 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0D0U))
#define C1FLTCON1bits (*(volatile pic32_can_fltcon1_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0D0U))
#define C1FLTCON1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0D4U))
#define C1FLTCON1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0D8U))
#define C1FLTCON1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0DCU))
#define C1FLTCON2 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0E0U))
#define C1FLTCON2bits (*(volatile pic32_can_fltcon2_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0E0U))
#define C1FLTCON2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0E4U))
#define C1FLTCON2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0E8U))
#define C1FLTCON2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0ECU))
#define C1FLTCON3 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0F0U))
#define C1FLTCON3bits (*(volatile pic32_can_fltcon3_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0F0U))
#define C1FLTCON3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0F4U))
#define C1FLTCON3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0F8U))
#define C1FLTCON3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x0FCU))
#define C1FLTCON4 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x100U))
#define C1FLTCON4bits (*(volatile pic32_can_fltcon4_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x100U))
#define C1FLTCON4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x104U))
#define C1FLTCON4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x108U))
#define C1FLTCON4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x10CU))
#define C1FLTCON5 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x110U))
#define C1FLTCON5bits (*(volatile pic32_can_fltcon5_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x110U))
#define C1FLTCON5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x114U))
#define C1FLTCON5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x118U))
#define C1FLTCON5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x11CU))
#define C1FLTCON6 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x120U))
#define C1FLTCON6bits (*(volatile pic32_can_fltcon6_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x120U))
#define C1FLTCON6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x124U))
#define C1FLTCON6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x128U))
#define C1FLTCON6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x12CU))
#define C1FLTCON7 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x130U))
#define C1FLTCON7bits (*(volatile pic32_can_fltcon7_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x130U))
#define C1FLTCON7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x134U))
#define C1FLTCON7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x138U))
#define C1FLTCON7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x13CU))
#define C1RXF0 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x140U))
#define C1RXF0bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x140U))
#define C1RXF0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x144U))
#define C1RXF0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x148U))
#define C1RXF0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x14CU))
#define C1RXF1 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x150U))
#define C1RXF1bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x150U))
#define C1RXF1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x154U))
#define C1RXF1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x158U))
#define C1RXF1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x15CU))
#define C1RXF2 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x160U))
#define C1RXF2bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x160U))
#define C1RXF2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x164U))
#define C1RXF2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x168U))
#define C1RXF2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x16CU))
#define C1RXF3 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x170U))
#define C1RXF3bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x170U))
#define C1RXF3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x174U))
#define C1RXF3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x178U))
#define C1RXF3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x17CU))
#define C1RXF4 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x180U))
#define C1RXF4bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x180U))
#define C1RXF4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x184U))
#define C1RXF4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x188U))
#define C1RXF4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x18CU))
#define C1RXF5 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x190U))
#define C1RXF5bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x190U))
#define C1RXF5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x194U))
#define C1RXF5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x198U))
#define C1RXF5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x19CU))
#define C1RXF6 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1A0U))
#define C1RXF6bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1A0U))
#define C1RXF6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1A4U))
#define C1RXF6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1A8U))
#define C1RXF6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1ACU))
#define C1RXF7 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1B0U))
#define C1RXF7bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1B0U))
#define C1RXF7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1B4U))
#define C1RXF7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1B8U))
#define C1RXF7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1BCU))
#define C1RXF8 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1C0U))
#define C1RXF8bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1C0U))
#define C1RXF8CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1C4U))
#define C1RXF8SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1C8U))
#define C1RXF8INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1CCU))
#define C1RXF9 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1D0U))
#define C1RXF9bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1D0U))
#define C1RXF9CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1D4U))
#define C1RXF9SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1D8U))
#define C1RXF9INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1DCU))
#define C1RXF10 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1E0U))
#define C1RXF10bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1E0U))
#define C1RXF10CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1E4U))
#define C1RXF10SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1E8U))
#define C1RXF10INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1ECU))
#define C1RXF11 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1F0U))
#define C1RXF11bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1F0U))
#define C1RXF11CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1F4U))
#define C1RXF11SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1F8U))
#define C1RXF11INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x1FCU))
#define C1RXF12 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x200U))
#define C1RXF12bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x200U))
#define C1RXF12CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x204U))
#define C1RXF12SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x208U))
#define C1RXF12INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x20CU))
#define C1RXF13 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x210U))
#define C1RXF13bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x210U))
#define C1RXF13CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x214U))
#define C1RXF13SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x218U))
#define C1RXF13INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x21CU))
#define C1RXF14 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x220U))
#define C1RXF14bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x220U))
#define C1RXF14CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x224U))
#define C1RXF14SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x228U))
#define C1RXF14INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x22CU))
#define C1RXF15 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x230U))
#define C1RXF15bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x230U))
#define C1RXF15CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x234U))
#define C1RXF15SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x238U))
#define C1RXF15INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x23CU))
#define C1RXF16 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x240U))
#define C1RXF16bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x240U))
#define C1RXF16CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x244U))
#define C1RXF16SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x248U))
#define C1RXF16INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x24CU))
#define C1RXF17 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x250U))
#define C1RXF17bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x250U))
#define C1RXF17CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x254U))
#define C1RXF17SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x258U))
#define C1RXF17INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x25CU))
#define C1RXF18 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x260U))
#define C1RXF18bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x260U))
#define C1RXF18CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x264U))
#define C1RXF18SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x268U))
#define C1RXF18INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x26CU))
#define C1RXF19 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x270U))
#define C1RXF19bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x270U))
#define C1RXF19CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x274U))
#define C1RXF19SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x278U))
#define C1RXF19INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x27CU))
#define C1RXF20 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x280U))
#define C1RXF20bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x280U))
#define C1RXF20CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x284U))
#define C1RXF20SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x288U))
#define C1RXF20INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x28CU))
#define C1RXF21 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x290U))
#define C1RXF21bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x290U))
#define C1RXF21CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x294U))
#define C1RXF21SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x298U))
#define C1RXF21INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x29CU))
#define C1RXF22 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2A0U))
#define C1RXF22bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2A0U))
#define C1RXF22CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2A4U))
#define C1RXF22SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2A8U))
#define C1RXF22INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2ACU))
#define C1RXF23 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2B0U))
#define C1RXF23bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2B0U))
#define C1RXF23CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2B4U))
#define C1RXF23SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2B8U))
#define C1RXF23INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2BCU))
#define C1RXF24 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2C0U))
#define C1RXF24bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2C0U))
#define C1RXF24CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2C4U))
#define C1RXF24SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2C8U))
#define C1RXF24INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2CCU))
#define C1RXF25 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2D0U))
#define C1RXF25bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2D0U))
#define C1RXF25CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2D4U))
#define C1RXF25SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2D8U))
#define C1RXF25INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2DCU))
#define C1RXF26 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2E0U))
#define C1RXF26bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2E0U))
#define C1RXF26CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2E4U))
#define C1RXF26SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2E8U))
#define C1RXF26INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2ECU))
#define C1RXF27 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2F0U))
#define C1RXF27bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2F0U))
#define C1RXF27CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2F4U))
#define C1RXF27SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2F8U))
#define C1RXF27INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x2FCU))
#define C1RXF28 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x300U))
#define C1RXF28bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x300U))
#define C1RXF28CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x304U))
#define C1RXF28SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x308U))
#define C1RXF28INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x30CU))
#define C1RXF29 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x310U))
#define C1RXF29bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x310U))
#define C1RXF29CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x314U))
#define C1RXF29SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x318U))
#define C1RXF29INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x31CU))
#define C1RXF30 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x320U))
#define C1RXF30bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x320U))
#define C1RXF30CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x324U))
#define C1RXF30SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x328U))
#define C1RXF30INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x32CU))
#define C1RXF31 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x330U))
#define C1RXF31bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x330U))
#define C1RXF31CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x334U))
#define C1RXF31SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x338U))
#define C1RXF31INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x33CU))
#define C1FIFOBA (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x340U))
#define C1FIFOBAbits (*(volatile pic32_can_fifo_ba_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x340U))
#define C1FIFOBACLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x344U))
#define C1FIFOBASET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x348U))
#define C1FIFOBAINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x34CU))
#define C1FIFOCON0 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x350U))
#define C1FIFOCON0bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x350U))
#define C1FIFOCON0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x354U))
#define C1FIFOCON0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x358U))
#define C1FIFOCON0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x35CU))
#define C1FIFOINT0 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x360U))
#define C1FIFOINT0bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x360U))
#define C1FIFOINT0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x364U))
#define C1FIFOINT0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x368U))
#define C1FIFOINT0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x36CU))
#define C1FIFOUA0 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x370U))
#define C1FIFOUA0bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x370U))
#define C1FIFOUA0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x374U))
#define C1FIFOUA0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x378U))
#define C1FIFOUA0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x37CU))
#define C1FIFOCI0 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x380U))
#define C1FIFOCI0bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x380U))
#define C1FIFOCI0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x384U))
#define C1FIFOCI0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x388U))
#define C1FIFOCI0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x38CU))
#define C1FIFOCON1 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x390U))
#define C1FIFOCON1bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x390U))
#define C1FIFOCON1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x394U))
#define C1FIFOCON1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x398U))
#define C1FIFOCON1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x39CU))
#define C1FIFOINT1 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3A0U))
#define C1FIFOINT1bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3A0U))
#define C1FIFOINT1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3A4U))
#define C1FIFOINT1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3A8U))
#define C1FIFOINT1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3ACU))
#define C1FIFOUA1 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3B0U))
#define C1FIFOUA1bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3B0U))
#define C1FIFOUA1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3B4U))
#define C1FIFOUA1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3B8U))
#define C1FIFOUA1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3BCU))
#define C1FIFOCI1 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3C0U))
#define C1FIFOCI1bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3C0U))
#define C1FIFOCI1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3C4U))
#define C1FIFOCI1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3C8U))
#define C1FIFOCI1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3CCU))
#define C1FIFOCON2 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3D0U))
#define C1FIFOCON2bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3D0U))
#define C1FIFOCON2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3D4U))
#define C1FIFOCON2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3D8U))
#define C1FIFOCON2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3DCU))
#define C1FIFOINT2 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3E0U))
#define C1FIFOINT2bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3E0U))
#define C1FIFOINT2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3E4U))
#define C1FIFOINT2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3E8U))
#define C1FIFOINT2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3ECU))
#define C1FIFOUA2 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3F0U))
#define C1FIFOUA2bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3F0U))
#define C1FIFOUA2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3F4U))
#define C1FIFOUA2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3F8U))
#define C1FIFOUA2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x3FCU))
#define C1FIFOCI2 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x400U))
#define C1FIFOCI2bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x400U))
#define C1FIFOCI2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x404U))
#define C1FIFOCI2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x408U))
#define C1FIFOCI2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x40CU))
#define C1FIFOCON3 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x410U))
#define C1FIFOCON3bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x410U))
#define C1FIFOCON3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x414U))
#define C1FIFOCON3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x418U))
#define C1FIFOCON3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x41CU))
#define C1FIFOINT3 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x420U))
#define C1FIFOINT3bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x420U))
#define C1FIFOINT3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x424U))
#define C1FIFOINT3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x428U))
#define C1FIFOINT3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x42CU))
#define C1FIFOUA3 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x430U))
#define C1FIFOUA3bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x430U))
#define C1FIFOUA3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x434U))
#define C1FIFOUA3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x438U))
#define C1FIFOUA3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x43CU))
#define C1FIFOCI3 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x440U))
#define C1FIFOCI3bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x440U))
#define C1FIFOCI3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x444U))
#define C1FIFOCI3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x448U))
#define C1FIFOCI3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x44CU))
#define C1FIFOCON4 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x450U))
#define C1FIFOCON4bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x450U))
#define C1FIFOCON4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x454U))
#define C1FIFOCON4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x458U))
#define C1FIFOCON4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x45CU))
#define C1FIFOINT4 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x460U))
#define C1FIFOINT4bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x460U))
#define C1FIFOINT4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x464U))
#define C1FIFOINT4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x468U))
#define C1FIFOINT4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x46CU))
#define C1FIFOUA4 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x470U))
#define C1FIFOUA4bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x470U))
#define C1FIFOUA4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x474U))
#define C1FIFOUA4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x478U))
#define C1FIFOUA4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x47CU))
#define C1FIFOCI4 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x480U))
#define C1FIFOCI4bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x480U))
#define C1FIFOCI4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x484U))
#define C1FIFOCI4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x488U))
#define C1FIFOCI4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x48CU))
#define C1FIFOCON5 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x490U))
#define C1FIFOCON5bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x490U))
#define C1FIFOCON5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x494U))
#define C1FIFOCON5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x498U))
#define C1FIFOCON5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x49CU))
#define C1FIFOINT5 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4A0U))
#define C1FIFOINT5bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4A0U))
#define C1FIFOINT5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4A4U))
#define C1FIFOINT5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4A8U))
#define C1FIFOINT5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4ACU))
#define C1FIFOUA5 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4B0U))
#define C1FIFOUA5bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4B0U))
#define C1FIFOUA5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4B4U))
#define C1FIFOUA5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4B8U))
#define C1FIFOUA5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4BCU))
#define C1FIFOCI5 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4C0U))
#define C1FIFOCI5bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4C0U))
#define C1FIFOCI5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4C4U))
#define C1FIFOCI5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4C8U))
#define C1FIFOCI5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4CCU))
#define C1FIFOCON6 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4D0U))
#define C1FIFOCON6bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4D0U))
#define C1FIFOCON6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4D4U))
#define C1FIFOCON6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4D8U))
#define C1FIFOCON6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4DCU))
#define C1FIFOINT6 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4E0U))
#define C1FIFOINT6bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4E0U))
#define C1FIFOINT6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4E4U))
#define C1FIFOINT6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4E8U))
#define C1FIFOINT6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4ECU))
#define C1FIFOUA6 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4F0U))
#define C1FIFOUA6bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4F0U))
#define C1FIFOUA6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4F4U))
#define C1FIFOUA6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4F8U))
#define C1FIFOUA6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x4FCU))
#define C1FIFOCI6 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x500U))
#define C1FIFOCI6bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x500U))
#define C1FIFOCI6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x504U))
#define C1FIFOCI6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x508U))
#define C1FIFOCI6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x50CU))
#define C1FIFOCON7 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x510U))
#define C1FIFOCON7bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x510U))
#define C1FIFOCON7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x514U))
#define C1FIFOCON7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x518U))
#define C1FIFOCON7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x51CU))
#define C1FIFOINT7 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x520U))
#define C1FIFOINT7bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x520U))
#define C1FIFOINT7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x524U))
#define C1FIFOINT7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x528U))
#define C1FIFOINT7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x52CU))
#define C1FIFOUA7 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x530U))
#define C1FIFOUA7bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x530U))
#define C1FIFOUA7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x534U))
#define C1FIFOUA7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x538U))
#define C1FIFOUA7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x53CU))
#define C1FIFOCI7 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x540U))
#define C1FIFOCI7bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x540U))
#define C1FIFOCI7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x544U))
#define C1FIFOCI7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x548U))
#define C1FIFOCI7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x54CU))
#define C1FIFOCON8 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x550U))
#define C1FIFOCON8bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x550U))
#define C1FIFOCON8CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x554U))
#define C1FIFOCON8SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x558U))
#define C1FIFOCON8INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x55CU))
#define C1FIFOINT8 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x560U))
#define C1FIFOINT8bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x560U))
#define C1FIFOINT8CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x564U))
#define C1FIFOINT8SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x568U))
#define C1FIFOINT8INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x56CU))
#define C1FIFOUA8 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x570U))
#define C1FIFOUA8bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x570U))
#define C1FIFOUA8CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x574U))
#define C1FIFOUA8SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x578U))
#define C1FIFOUA8INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x57CU))
#define C1FIFOCI8 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x580U))
#define C1FIFOCI8bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x580U))
#define C1FIFOCI8CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x584U))
#define C1FIFOCI8SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x588U))
#define C1FIFOCI8INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x58CU))
#define C1FIFOCON9 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x590U))
#define C1FIFOCON9bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x590U))
#define C1FIFOCON9CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x594U))
#define C1FIFOCON9SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x598U))
#define C1FIFOCON9INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x59CU))
#define C1FIFOINT9 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5A0U))
#define C1FIFOINT9bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5A0U))
#define C1FIFOINT9CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5A4U))
#define C1FIFOINT9SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5A8U))
#define C1FIFOINT9INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5ACU))
#define C1FIFOUA9 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5B0U))
#define C1FIFOUA9bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5B0U))
#define C1FIFOUA9CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5B4U))
#define C1FIFOUA9SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5B8U))
#define C1FIFOUA9INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5BCU))
#define C1FIFOCI9 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5C0U))
#define C1FIFOCI9bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5C0U))
#define C1FIFOCI9CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5C4U))
#define C1FIFOCI9SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5C8U))
#define C1FIFOCI9INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5CCU))
#define C1FIFOCON10 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5D0U))
#define C1FIFOCON10bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5D0U))
#define C1FIFOCON10CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5D4U))
#define C1FIFOCON10SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5D8U))
#define C1FIFOCON10INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5DCU))
#define C1FIFOINT10 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5E0U))
#define C1FIFOINT10bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5E0U))
#define C1FIFOINT10CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5E4U))
#define C1FIFOINT10SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5E8U))
#define C1FIFOINT10INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5ECU))
#define C1FIFOUA10 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5F0U))
#define C1FIFOUA10bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5F0U))
#define C1FIFOUA10CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5F4U))
#define C1FIFOUA10SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5F8U))
#define C1FIFOUA10INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x5FCU))
#define C1FIFOCI10 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x600U))
#define C1FIFOCI10bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x600U))
#define C1FIFOCI10CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x604U))
#define C1FIFOCI10SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x608U))
#define C1FIFOCI10INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x60CU))
#define C1FIFOCON11 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x610U))
#define C1FIFOCON11bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x610U))
#define C1FIFOCON11CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x614U))
#define C1FIFOCON11SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x618U))
#define C1FIFOCON11INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x61CU))
#define C1FIFOINT11 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x620U))
#define C1FIFOINT11bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x620U))
#define C1FIFOINT11CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x624U))
#define C1FIFOINT11SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x628U))
#define C1FIFOINT11INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x62CU))
#define C1FIFOUA11 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x630U))
#define C1FIFOUA11bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x630U))
#define C1FIFOUA11CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x634U))
#define C1FIFOUA11SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x638U))
#define C1FIFOUA11INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x63CU))
#define C1FIFOCI11 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x640U))
#define C1FIFOCI11bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x640U))
#define C1FIFOCI11CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x644U))
#define C1FIFOCI11SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x648U))
#define C1FIFOCI11INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x64CU))
#define C1FIFOCON12 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x650U))
#define C1FIFOCON12bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x650U))
#define C1FIFOCON12CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x654U))
#define C1FIFOCON12SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x658U))
#define C1FIFOCON12INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x65CU))
#define C1FIFOINT12 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x660U))
#define C1FIFOINT12bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x660U))
#define C1FIFOINT12CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x664U))
#define C1FIFOINT12SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x668U))
#define C1FIFOINT12INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x66CU))
#define C1FIFOUA12 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x670U))
#define C1FIFOUA12bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x670U))
#define C1FIFOUA12CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x674U))
#define C1FIFOUA12SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x678U))
#define C1FIFOUA12INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x67CU))
#define C1FIFOCI12 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x680U))
#define C1FIFOCI12bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x680U))
#define C1FIFOCI12CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x684U))
#define C1FIFOCI12SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x688U))
#define C1FIFOCI12INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x68CU))
#define C1FIFOCON13 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x690U))
#define C1FIFOCON13bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x690U))
#define C1FIFOCON13CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x694U))
#define C1FIFOCON13SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x698U))
#define C1FIFOCON13INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x69CU))
#define C1FIFOINT13 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6A0U))
#define C1FIFOINT13bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6A0U))
#define C1FIFOINT13CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6A4U))
#define C1FIFOINT13SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6A8U))
#define C1FIFOINT13INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6ACU))
#define C1FIFOUA13 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6B0U))
#define C1FIFOUA13bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6B0U))
#define C1FIFOUA13CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6B4U))
#define C1FIFOUA13SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6B8U))
#define C1FIFOUA13INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6BCU))
#define C1FIFOCI13 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6C0U))
#define C1FIFOCI13bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6C0U))
#define C1FIFOCI13CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6C4U))
#define C1FIFOCI13SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6C8U))
#define C1FIFOCI13INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6CCU))
#define C1FIFOCON14 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6D0U))
#define C1FIFOCON14bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6D0U))
#define C1FIFOCON14CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6D4U))
#define C1FIFOCON14SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6D8U))
#define C1FIFOCON14INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6DCU))
#define C1FIFOINT14 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6E0U))
#define C1FIFOINT14bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6E0U))
#define C1FIFOINT14CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6E4U))
#define C1FIFOINT14SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6E8U))
#define C1FIFOINT14INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6ECU))
#define C1FIFOUA14 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6F0U))
#define C1FIFOUA14bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6F0U))
#define C1FIFOUA14CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6F4U))
#define C1FIFOUA14SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6F8U))
#define C1FIFOUA14INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x6FCU))
#define C1FIFOCI14 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x700U))
#define C1FIFOCI14bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x700U))
#define C1FIFOCI14CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x704U))
#define C1FIFOCI14SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x708U))
#define C1FIFOCI14INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x70CU))
#define C1FIFOCON15 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x710U))
#define C1FIFOCON15bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x710U))
#define C1FIFOCON15CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x714U))
#define C1FIFOCON15SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x718U))
#define C1FIFOCON15INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x71CU))
#define C1FIFOINT15 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x720U))
#define C1FIFOINT15bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x720U))
#define C1FIFOINT15CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x724U))
#define C1FIFOINT15SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x728U))
#define C1FIFOINT15INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x72CU))
#define C1FIFOUA15 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x730U))
#define C1FIFOUA15bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x730U))
#define C1FIFOUA15CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x734U))
#define C1FIFOUA15SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x738U))
#define C1FIFOUA15INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x73CU))
#define C1FIFOCI15 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x740U))
#define C1FIFOCI15bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x740U))
#define C1FIFOCI15CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x744U))
#define C1FIFOCI15SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x748U))
#define C1FIFOCI15INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x74CU))
#define C1FIFOCON16 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x750U))
#define C1FIFOCON16bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x750U))
#define C1FIFOCON16CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x754U))
#define C1FIFOCON16SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x758U))
#define C1FIFOCON16INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x75CU))
#define C1FIFOINT16 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x760U))
#define C1FIFOINT16bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x760U))
#define C1FIFOINT16CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x764U))
#define C1FIFOINT16SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x768U))
#define C1FIFOINT16INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x76CU))
#define C1FIFOUA16 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x770U))
#define C1FIFOUA16bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x770U))
#define C1FIFOUA16CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x774U))
#define C1FIFOUA16SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x778U))
#define C1FIFOUA16INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x77CU))
#define C1FIFOCI16 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x780U))
#define C1FIFOCI16bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x780U))
#define C1FIFOCI16CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x784U))
#define C1FIFOCI16SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x788U))
#define C1FIFOCI16INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x78CU))
#define C1FIFOCON17 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x790U))
#define C1FIFOCON17bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x790U))
#define C1FIFOCON17CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x794U))
#define C1FIFOCON17SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x798U))
#define C1FIFOCON17INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x79CU))
#define C1FIFOINT17 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7A0U))
#define C1FIFOINT17bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7A0U))
#define C1FIFOINT17CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7A4U))
#define C1FIFOINT17SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7A8U))
#define C1FIFOINT17INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7ACU))
#define C1FIFOUA17 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7B0U))
#define C1FIFOUA17bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7B0U))
#define C1FIFOUA17CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7B4U))
#define C1FIFOUA17SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7B8U))
#define C1FIFOUA17INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7BCU))
#define C1FIFOCI17 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7C0U))
#define C1FIFOCI17bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7C0U))
#define C1FIFOCI17CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7C4U))
#define C1FIFOCI17SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7C8U))
#define C1FIFOCI17INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7CCU))
#define C1FIFOCON18 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7D0U))
#define C1FIFOCON18bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7D0U))
#define C1FIFOCON18CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7D4U))
#define C1FIFOCON18SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7D8U))
#define C1FIFOCON18INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7DCU))
#define C1FIFOINT18 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7E0U))
#define C1FIFOINT18bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7E0U))
#define C1FIFOINT18CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7E4U))
#define C1FIFOINT18SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7E8U))
#define C1FIFOINT18INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7ECU))
#define C1FIFOUA18 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7F0U))
#define C1FIFOUA18bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7F0U))
#define C1FIFOUA18CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7F4U))
#define C1FIFOUA18SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7F8U))
#define C1FIFOUA18INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x7FCU))
#define C1FIFOCI18 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x800U))
#define C1FIFOCI18bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x800U))
#define C1FIFOCI18CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x804U))
#define C1FIFOCI18SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x808U))
#define C1FIFOCI18INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x80CU))
#define C1FIFOCON19 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x810U))
#define C1FIFOCON19bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x810U))
#define C1FIFOCON19CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x814U))
#define C1FIFOCON19SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x818U))
#define C1FIFOCON19INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x81CU))
#define C1FIFOINT19 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x820U))
#define C1FIFOINT19bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x820U))
#define C1FIFOINT19CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x824U))
#define C1FIFOINT19SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x828U))
#define C1FIFOINT19INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x82CU))
#define C1FIFOUA19 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x830U))
#define C1FIFOUA19bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x830U))
#define C1FIFOUA19CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x834U))
#define C1FIFOUA19SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x838U))
#define C1FIFOUA19INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x83CU))
#define C1FIFOCI19 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x840U))
#define C1FIFOCI19bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x840U))
#define C1FIFOCI19CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x844U))
#define C1FIFOCI19SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x848U))
#define C1FIFOCI19INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x84CU))
#define C1FIFOCON20 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x850U))
#define C1FIFOCON20bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x850U))
#define C1FIFOCON20CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x854U))
#define C1FIFOCON20SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x858U))
#define C1FIFOCON20INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x85CU))
#define C1FIFOINT20 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x860U))
#define C1FIFOINT20bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x860U))
#define C1FIFOINT20CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x864U))
#define C1FIFOINT20SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x868U))
#define C1FIFOINT20INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x86CU))
#define C1FIFOUA20 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x870U))
#define C1FIFOUA20bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x870U))
#define C1FIFOUA20CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x874U))
#define C1FIFOUA20SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x878U))
#define C1FIFOUA20INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x87CU))
#define C1FIFOCI20 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x880U))
#define C1FIFOCI20bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x880U))
#define C1FIFOCI20CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x884U))
#define C1FIFOCI20SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x888U))
#define C1FIFOCI20INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x88CU))
#define C1FIFOCON21 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x890U))
#define C1FIFOCON21bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x890U))
#define C1FIFOCON21CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x894U))
#define C1FIFOCON21SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x898U))
#define C1FIFOCON21INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x89CU))
#define C1FIFOINT21 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8A0U))
#define C1FIFOINT21bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8A0U))
#define C1FIFOINT21CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8A4U))
#define C1FIFOINT21SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8A8U))
#define C1FIFOINT21INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8ACU))
#define C1FIFOUA21 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8B0U))
#define C1FIFOUA21bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8B0U))
#define C1FIFOUA21CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8B4U))
#define C1FIFOUA21SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8B8U))
#define C1FIFOUA21INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8BCU))
#define C1FIFOCI21 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8C0U))
#define C1FIFOCI21bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8C0U))
#define C1FIFOCI21CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8C4U))
#define C1FIFOCI21SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8C8U))
#define C1FIFOCI21INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8CCU))
#define C1FIFOCON22 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8D0U))
#define C1FIFOCON22bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8D0U))
#define C1FIFOCON22CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8D4U))
#define C1FIFOCON22SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8D8U))
#define C1FIFOCON22INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8DCU))
#define C1FIFOINT22 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8E0U))
#define C1FIFOINT22bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8E0U))
#define C1FIFOINT22CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8E4U))
#define C1FIFOINT22SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8E8U))
#define C1FIFOINT22INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8ECU))
#define C1FIFOUA22 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8F0U))
#define C1FIFOUA22bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8F0U))
#define C1FIFOUA22CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8F4U))
#define C1FIFOUA22SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8F8U))
#define C1FIFOUA22INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x8FCU))
#define C1FIFOCI22 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x900U))
#define C1FIFOCI22bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x900U))
#define C1FIFOCI22CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x904U))
#define C1FIFOCI22SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x908U))
#define C1FIFOCI22INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x90CU))
#define C1FIFOCON23 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x910U))
#define C1FIFOCON23bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x910U))
#define C1FIFOCON23CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x914U))
#define C1FIFOCON23SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x918U))
#define C1FIFOCON23INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x91CU))
#define C1FIFOINT23 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x920U))
#define C1FIFOINT23bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x920U))
#define C1FIFOINT23CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x924U))
#define C1FIFOINT23SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x928U))
#define C1FIFOINT23INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x92CU))
#define C1FIFOUA23 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x930U))
#define C1FIFOUA23bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x930U))
#define C1FIFOUA23CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x934U))
#define C1FIFOUA23SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x938U))
#define C1FIFOUA23INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x93CU))
#define C1FIFOCI23 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x940U))
#define C1FIFOCI23bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x940U))
#define C1FIFOCI23CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x944U))
#define C1FIFOCI23SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x948U))
#define C1FIFOCI23INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x94CU))
#define C1FIFOCON24 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x950U))
#define C1FIFOCON24bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x950U))
#define C1FIFOCON24CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x954U))
#define C1FIFOCON24SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x958U))
#define C1FIFOCON24INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x95CU))
#define C1FIFOINT24 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x960U))
#define C1FIFOINT24bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x960U))
#define C1FIFOINT24CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x964U))
#define C1FIFOINT24SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x968U))
#define C1FIFOINT24INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x96CU))
#define C1FIFOUA24 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x970U))
#define C1FIFOUA24bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x970U))
#define C1FIFOUA24CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x974U))
#define C1FIFOUA24SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x978U))
#define C1FIFOUA24INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x97CU))
#define C1FIFOCI24 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x980U))
#define C1FIFOCI24bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x980U))
#define C1FIFOCI24CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x984U))
#define C1FIFOCI24SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x988U))
#define C1FIFOCI24INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x98CU))
#define C1FIFOCON25 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x990U))
#define C1FIFOCON25bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x990U))
#define C1FIFOCON25CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x994U))
#define C1FIFOCON25SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x998U))
#define C1FIFOCON25INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x99CU))
#define C1FIFOINT25 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9A0U))
#define C1FIFOINT25bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9A0U))
#define C1FIFOINT25CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9A4U))
#define C1FIFOINT25SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9A8U))
#define C1FIFOINT25INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9ACU))
#define C1FIFOUA25 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9B0U))
#define C1FIFOUA25bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9B0U))
#define C1FIFOUA25CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9B4U))
#define C1FIFOUA25SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9B8U))
#define C1FIFOUA25INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9BCU))
#define C1FIFOCI25 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9C0U))
#define C1FIFOCI25bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9C0U))
#define C1FIFOCI25CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9C4U))
#define C1FIFOCI25SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9C8U))
#define C1FIFOCI25INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9CCU))
#define C1FIFOCON26 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9D0U))
#define C1FIFOCON26bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9D0U))
#define C1FIFOCON26CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9D4U))
#define C1FIFOCON26SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9D8U))
#define C1FIFOCON26INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9DCU))
#define C1FIFOINT26 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9E0U))
#define C1FIFOINT26bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9E0U))
#define C1FIFOINT26CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9E4U))
#define C1FIFOINT26SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9E8U))
#define C1FIFOINT26INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9ECU))
#define C1FIFOUA26 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9F0U))
#define C1FIFOUA26bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9F0U))
#define C1FIFOUA26CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9F4U))
#define C1FIFOUA26SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9F8U))
#define C1FIFOUA26INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0x9FCU))
#define C1FIFOCI26 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA00U))
#define C1FIFOCI26bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA00U))
#define C1FIFOCI26CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA04U))
#define C1FIFOCI26SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA08U))
#define C1FIFOCI26INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA0CU))
#define C1FIFOCON27 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA10U))
#define C1FIFOCON27bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA10U))
#define C1FIFOCON27CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA14U))
#define C1FIFOCON27SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA18U))
#define C1FIFOCON27INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA1CU))
#define C1FIFOINT27 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA20U))
#define C1FIFOINT27bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA20U))
#define C1FIFOINT27CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA24U))
#define C1FIFOINT27SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA28U))
#define C1FIFOINT27INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA2CU))
#define C1FIFOUA27 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA30U))
#define C1FIFOUA27bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA30U))
#define C1FIFOUA27CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA34U))
#define C1FIFOUA27SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA38U))
#define C1FIFOUA27INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA3CU))
#define C1FIFOCI27 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA40U))
#define C1FIFOCI27bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA40U))
#define C1FIFOCI27CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA44U))
#define C1FIFOCI27SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA48U))
#define C1FIFOCI27INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA4CU))
#define C1FIFOCON28 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA50U))
#define C1FIFOCON28bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA50U))
#define C1FIFOCON28CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA54U))
#define C1FIFOCON28SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA58U))
#define C1FIFOCON28INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA5CU))
#define C1FIFOINT28 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA60U))
#define C1FIFOINT28bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA60U))
#define C1FIFOINT28CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA64U))
#define C1FIFOINT28SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA68U))
#define C1FIFOINT28INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA6CU))
#define C1FIFOUA28 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA70U))
#define C1FIFOUA28bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA70U))
#define C1FIFOUA28CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA74U))
#define C1FIFOUA28SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA78U))
#define C1FIFOUA28INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA7CU))
#define C1FIFOCI28 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA80U))
#define C1FIFOCI28bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA80U))
#define C1FIFOCI28CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA84U))
#define C1FIFOCI28SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA88U))
#define C1FIFOCI28INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA8CU))
#define C1FIFOCON29 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA90U))
#define C1FIFOCON29bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA90U))
#define C1FIFOCON29CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA94U))
#define C1FIFOCON29SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA98U))
#define C1FIFOCON29INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xA9CU))
#define C1FIFOINT29 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAA0U))
#define C1FIFOINT29bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAA0U))
#define C1FIFOINT29CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAA4U))
#define C1FIFOINT29SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAA8U))
#define C1FIFOINT29INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAACU))
#define C1FIFOUA29 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAB0U))
#define C1FIFOUA29bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAB0U))
#define C1FIFOUA29CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAB4U))
#define C1FIFOUA29SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAB8U))
#define C1FIFOUA29INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xABCU))
#define C1FIFOCI29 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAC0U))
#define C1FIFOCI29bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAC0U))
#define C1FIFOCI29CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAC4U))
#define C1FIFOCI29SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAC8U))
#define C1FIFOCI29INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xACCU))
#define C1FIFOCON30 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAD0U))
#define C1FIFOCON30bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAD0U))
#define C1FIFOCON30CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAD4U))
#define C1FIFOCON30SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAD8U))
#define C1FIFOCON30INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xADCU))
#define C1FIFOINT30 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAE0U))
#define C1FIFOINT30bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAE0U))
#define C1FIFOINT30CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAE4U))
#define C1FIFOINT30SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAE8U))
#define C1FIFOINT30INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAECU))
#define C1FIFOUA30 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAF0U))
#define C1FIFOUA30bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAF0U))
#define C1FIFOUA30CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAF4U))
#define C1FIFOUA30SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAF8U))
#define C1FIFOUA30INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xAFCU))
#define C1FIFOCI30 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB00U))
#define C1FIFOCI30bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB00U))
#define C1FIFOCI30CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB04U))
#define C1FIFOCI30SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB08U))
#define C1FIFOCI30INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB0CU))
#define C1FIFOCON31 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB10U))
#define C1FIFOCON31bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB10U))
#define C1FIFOCON31CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB14U))
#define C1FIFOCON31SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB18U))
#define C1FIFOCON31INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB1CU))
#define C1FIFOINT31 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB20U))
#define C1FIFOINT31bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB20U))
#define C1FIFOINT31CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB24U))
#define C1FIFOINT31SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB28U))
#define C1FIFOINT31INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB2CU))
#define C1FIFOUA31 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB30U))
#define C1FIFOUA31bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB30U))
#define C1FIFOUA31CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB34U))
#define C1FIFOUA31SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB38U))
#define C1FIFOUA31INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB3CU))
#define C1FIFOCI31 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB40U))
#define C1FIFOCI31bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB40U))
#define C1FIFOCI31CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB44U))
#define C1FIFOCI31SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB48U))
#define C1FIFOCI31INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C1_BASE + 0xB4CU))
#endif
#ifndef PIC32_CAN_C2_BASE
#define PIC32_CAN_C2_BASE PIC32_CAN_CAN2_BASE
#endif
#ifdef PIC32_CAN_C2_BASE
#define C2CON (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x000U))
#define C2CONbits (*(volatile pic32_can_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x000U))
#define C2CONCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x004U))
#define C2CONSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x008U))
#define C2CONINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x00CU))
#define C2CFG (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x010U))
#define C2CFGbits (*(volatile pic32_can_cfg_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x010U))
#define C2CFGCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x014U))
#define C2CFGSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x018U))
#define C2CFGINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x01CU))
#define C2INT (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x020U))
#define C2INTbits (*(const volatile pic32_can_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x020U))
#define C2INTCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x024U))
#define C2INTSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x028U))
#define C2INTINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x02CU))
#define C2VEC (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x030U))
#define C2VECbits (*(const volatile pic32_can_vec_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x030U))
#define C2VECCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x034U))
#define C2VECSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x038U))
#define C2VECINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x03CU))
#define C2TREC (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x040U))
#define C2TRECbits (*(const volatile pic32_can_trec_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x040U))
#define C2TRECCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x044U))
#define C2TRECSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x048U))
#define C2TRECINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x04CU))
#define C2FSTAT (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x050U))
#define C2FSTATbits (*(const volatile pic32_can_fstat_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x050U))
#define C2FSTATCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x054U))
#define C2FSTATSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x058U))
#define C2FSTATINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x05CU))
#define C2RXOVF (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x060U))
#define C2RXOVFbits (*(const volatile pic32_can_rxovf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x060U))
#define C2RXOVFCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x064U))
#define C2RXOVFSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x068U))
#define C2RXOVFINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x06CU))
#define C2TMR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x070U))
#define C2TMRbits (*(const volatile pic32_can_tmr_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x070U))
#define C2TMRCLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x074U))
#define C2TMRSET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x078U))
#define C2TMRINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x07CU))
#define C2RXM0 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x080U))
#define C2RXM0bits (*(volatile pic32_can_rxm_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x080U))
#define C2RXM0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x084U))
#define C2RXM0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x088U))
#define C2RXM0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x08CU))
#define C2RXM1 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x090U))
#define C2RXM1bits (*(volatile pic32_can_rxm_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x090U))
#define C2RXM1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x094U))
#define C2RXM1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x098U))
#define C2RXM1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x09CU))
#define C2RXM2 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0A0U))
#define C2RXM2bits (*(volatile pic32_can_rxm_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0A0U))
#define C2RXM2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0A4U))
#define C2RXM2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0A8U))
#define C2RXM2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0ACU))
#define C2RXM3 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0B0U))
#define C2RXM3bits (*(volatile pic32_can_rxm_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0B0U))
#define C2RXM3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0B4U))
#define C2RXM3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0B8U))
#define C2RXM3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0BCU))
#define C2FLTCON0 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0C0U))
#define C2FLTCON0bits (*(volatile pic32_can_fltcon0_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0C0U))
#define C2FLTCON0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0C4U))
#define C2FLTCON0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0C8U))
#define C2FLTCON0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0CCU))
#define C2FLTCON1 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0D0U))
#define C2FLTCON1bits (*(volatile pic32_can_fltcon1_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0D0U))
#define C2FLTCON1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0D4U))
#define C2FLTCON1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0D8U))
#define C2FLTCON1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0DCU))
#define C2FLTCON2 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0E0U))
#define C2FLTCON2bits (*(volatile pic32_can_fltcon2_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0E0U))
#define C2FLTCON2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0E4U))
#define C2FLTCON2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0E8U))
#define C2FLTCON2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0ECU))
#define C2FLTCON3 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0F0U))
#define C2FLTCON3bits (*(volatile pic32_can_fltcon3_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0F0U))
#define C2FLTCON3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0F4U))
#define C2FLTCON3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0F8U))
#define C2FLTCON3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x0FCU))
#define C2FLTCON4 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x100U))
#define C2FLTCON4bits (*(volatile pic32_can_fltcon4_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x100U))
#define C2FLTCON4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x104U))
#define C2FLTCON4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x108U))
#define C2FLTCON4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x10CU))
#define C2FLTCON5 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x110U))
#define C2FLTCON5bits (*(volatile pic32_can_fltcon5_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x110U))
#define C2FLTCON5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x114U))
#define C2FLTCON5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x118U))
#define C2FLTCON5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x11CU))
#define C2FLTCON6 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x120U))
#define C2FLTCON6bits (*(volatile pic32_can_fltcon6_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x120U))
#define C2FLTCON6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x124U))
#define C2FLTCON6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x128U))
#define C2FLTCON6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x12CU))
#define C2FLTCON7 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x130U))
#define C2FLTCON7bits (*(volatile pic32_can_fltcon7_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x130U))
#define C2FLTCON7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x134U))
#define C2FLTCON7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x138U))
#define C2FLTCON7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x13CU))
#define C2RXF0 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x140U))
#define C2RXF0bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x140U))
#define C2RXF0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x144U))
#define C2RXF0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x148U))
#define C2RXF0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x14CU))
#define C2RXF1 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x150U))
#define C2RXF1bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x150U))
#define C2RXF1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x154U))
#define C2RXF1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x158U))
#define C2RXF1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x15CU))
#define C2RXF2 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x160U))
#define C2RXF2bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x160U))
#define C2RXF2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x164U))
#define C2RXF2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x168U))
#define C2RXF2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x16CU))
#define C2RXF3 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x170U))
#define C2RXF3bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x170U))
#define C2RXF3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x174U))
#define C2RXF3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x178U))
#define C2RXF3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x17CU))
#define C2RXF4 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x180U))
#define C2RXF4bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x180U))
#define C2RXF4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x184U))
#define C2RXF4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x188U))
#define C2RXF4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x18CU))
#define C2RXF5 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x190U))
#define C2RXF5bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x190U))
#define C2RXF5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x194U))
#define C2RXF5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x198U))
#define C2RXF5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x19CU))
#define C2RXF6 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1A0U))
#define C2RXF6bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1A0U))
#define C2RXF6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1A4U))
#define C2RXF6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1A8U))
#define C2RXF6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1ACU))
#define C2RXF7 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1B0U))
#define C2RXF7bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1B0U))
#define C2RXF7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1B4U))
#define C2RXF7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1B8U))
#define C2RXF7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1BCU))
#define C2RXF8 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1C0U))
#define C2RXF8bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1C0U))
#define C2RXF8CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1C4U))
#define C2RXF8SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1C8U))
#define C2RXF8INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1CCU))
#define C2RXF9 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1D0U))
#define C2RXF9bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1D0U))
#define C2RXF9CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1D4U))
#define C2RXF9SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1D8U))
#define C2RXF9INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1DCU))
#define C2RXF10 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1E0U))
#define C2RXF10bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1E0U))
#define C2RXF10CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1E4U))
#define C2RXF10SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1E8U))
#define C2RXF10INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1ECU))
#define C2RXF11 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1F0U))
#define C2RXF11bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1F0U))
#define C2RXF11CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1F4U))
#define C2RXF11SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1F8U))
#define C2RXF11INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x1FCU))
#define C2RXF12 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x200U))
#define C2RXF12bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x200U))
#define C2RXF12CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x204U))
#define C2RXF12SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x208U))
#define C2RXF12INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x20CU))
#define C2RXF13 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x210U))
#define C2RXF13bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x210U))
#define C2RXF13CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x214U))
#define C2RXF13SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x218U))
#define C2RXF13INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x21CU))
#define C2RXF14 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x220U))
#define C2RXF14bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x220U))
#define C2RXF14CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x224U))
#define C2RXF14SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x228U))
#define C2RXF14INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x22CU))
#define C2RXF15 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x230U))
#define C2RXF15bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x230U))
#define C2RXF15CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x234U))
#define C2RXF15SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x238U))
#define C2RXF15INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x23CU))
#define C2RXF16 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x240U))
#define C2RXF16bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x240U))
#define C2RXF16CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x244U))
#define C2RXF16SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x248U))
#define C2RXF16INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x24CU))
#define C2RXF17 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x250U))
#define C2RXF17bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x250U))
#define C2RXF17CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x254U))
#define C2RXF17SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x258U))
#define C2RXF17INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x25CU))
#define C2RXF18 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x260U))
#define C2RXF18bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x260U))
#define C2RXF18CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x264U))
#define C2RXF18SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x268U))
#define C2RXF18INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x26CU))
#define C2RXF19 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x270U))
#define C2RXF19bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x270U))
#define C2RXF19CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x274U))
#define C2RXF19SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x278U))
#define C2RXF19INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x27CU))
#define C2RXF20 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x280U))
#define C2RXF20bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x280U))
#define C2RXF20CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x284U))
#define C2RXF20SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x288U))
#define C2RXF20INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x28CU))
#define C2RXF21 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x290U))
#define C2RXF21bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x290U))
#define C2RXF21CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x294U))
#define C2RXF21SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x298U))
#define C2RXF21INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x29CU))
#define C2RXF22 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2A0U))
#define C2RXF22bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2A0U))
#define C2RXF22CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2A4U))
#define C2RXF22SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2A8U))
#define C2RXF22INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2ACU))
#define C2RXF23 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2B0U))
#define C2RXF23bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2B0U))
#define C2RXF23CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2B4U))
#define C2RXF23SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2B8U))
#define C2RXF23INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2BCU))
#define C2RXF24 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2C0U))
#define C2RXF24bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2C0U))
#define C2RXF24CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2C4U))
#define C2RXF24SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2C8U))
#define C2RXF24INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2CCU))
#define C2RXF25 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2D0U))
#define C2RXF25bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2D0U))
#define C2RXF25CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2D4U))
#define C2RXF25SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2D8U))
#define C2RXF25INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2DCU))
#define C2RXF26 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2E0U))
#define C2RXF26bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2E0U))
#define C2RXF26CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2E4U))
#define C2RXF26SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2E8U))
#define C2RXF26INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2ECU))
#define C2RXF27 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2F0U))
#define C2RXF27bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2F0U))
#define C2RXF27CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2F4U))
#define C2RXF27SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2F8U))
#define C2RXF27INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x2FCU))
#define C2RXF28 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x300U))
#define C2RXF28bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x300U))
#define C2RXF28CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x304U))
#define C2RXF28SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x308U))
#define C2RXF28INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x30CU))
#define C2RXF29 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x310U))
#define C2RXF29bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x310U))
#define C2RXF29CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x314U))
#define C2RXF29SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x318U))
#define C2RXF29INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x31CU))
#define C2RXF30 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x320U))
#define C2RXF30bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x320U))
#define C2RXF30CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x324U))
#define C2RXF30SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x328U))
#define C2RXF30INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x32CU))
#define C2RXF31 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x330U))
#define C2RXF31bits (*(volatile pic32_can_rxf_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x330U))
#define C2RXF31CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x334U))
#define C2RXF31SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x338U))
#define C2RXF31INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x33CU))
#define C2FIFOBA (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x340U))
#define C2FIFOBAbits (*(volatile pic32_can_fifo_ba_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x340U))
#define C2FIFOBACLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x344U))
#define C2FIFOBASET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x348U))
#define C2FIFOBAINV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x34CU))
#define C2FIFOCON0 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x350U))
#define C2FIFOCON0bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x350U))
#define C2FIFOCON0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x354U))
#define C2FIFOCON0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x358U))
#define C2FIFOCON0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x35CU))
#define C2FIFOINT0 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x360U))
#define C2FIFOINT0bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x360U))
#define C2FIFOINT0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x364U))
#define C2FIFOINT0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x368U))
#define C2FIFOINT0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x36CU))
#define C2FIFOUA0 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x370U))
#define C2FIFOUA0bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x370U))
#define C2FIFOUA0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x374U))
#define C2FIFOUA0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x378U))
#define C2FIFOUA0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x37CU))
#define C2FIFOCI0 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x380U))
#define C2FIFOCI0bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x380U))
#define C2FIFOCI0CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x384U))
#define C2FIFOCI0SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x388U))
#define C2FIFOCI0INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x38CU))
#define C2FIFOCON1 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x390U))
#define C2FIFOCON1bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x390U))
#define C2FIFOCON1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x394U))
#define C2FIFOCON1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x398U))
#define C2FIFOCON1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x39CU))
#define C2FIFOINT1 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3A0U))
#define C2FIFOINT1bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3A0U))
#define C2FIFOINT1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3A4U))
#define C2FIFOINT1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3A8U))
#define C2FIFOINT1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3ACU))
#define C2FIFOUA1 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3B0U))
#define C2FIFOUA1bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3B0U))
#define C2FIFOUA1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3B4U))
#define C2FIFOUA1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3B8U))
#define C2FIFOUA1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3BCU))
#define C2FIFOCI1 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3C0U))
#define C2FIFOCI1bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3C0U))
#define C2FIFOCI1CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3C4U))
#define C2FIFOCI1SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3C8U))
#define C2FIFOCI1INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3CCU))
#define C2FIFOCON2 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3D0U))
#define C2FIFOCON2bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3D0U))
#define C2FIFOCON2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3D4U))
#define C2FIFOCON2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3D8U))
#define C2FIFOCON2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3DCU))
#define C2FIFOINT2 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3E0U))
#define C2FIFOINT2bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3E0U))
#define C2FIFOINT2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3E4U))
#define C2FIFOINT2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3E8U))
#define C2FIFOINT2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3ECU))
#define C2FIFOUA2 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3F0U))
#define C2FIFOUA2bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3F0U))
#define C2FIFOUA2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3F4U))
#define C2FIFOUA2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3F8U))
#define C2FIFOUA2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x3FCU))
#define C2FIFOCI2 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x400U))
#define C2FIFOCI2bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x400U))
#define C2FIFOCI2CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x404U))
#define C2FIFOCI2SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x408U))
#define C2FIFOCI2INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x40CU))
#define C2FIFOCON3 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x410U))
#define C2FIFOCON3bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x410U))
#define C2FIFOCON3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x414U))
#define C2FIFOCON3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x418U))
#define C2FIFOCON3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x41CU))
#define C2FIFOINT3 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x420U))
#define C2FIFOINT3bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x420U))
#define C2FIFOINT3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x424U))
#define C2FIFOINT3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x428U))
#define C2FIFOINT3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x42CU))
#define C2FIFOUA3 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x430U))
#define C2FIFOUA3bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x430U))
#define C2FIFOUA3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x434U))
#define C2FIFOUA3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x438U))
#define C2FIFOUA3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x43CU))
#define C2FIFOCI3 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x440U))
#define C2FIFOCI3bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x440U))
#define C2FIFOCI3CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x444U))
#define C2FIFOCI3SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x448U))
#define C2FIFOCI3INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x44CU))
#define C2FIFOCON4 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x450U))
#define C2FIFOCON4bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x450U))
#define C2FIFOCON4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x454U))
#define C2FIFOCON4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x458U))
#define C2FIFOCON4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x45CU))
#define C2FIFOINT4 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x460U))
#define C2FIFOINT4bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x460U))
#define C2FIFOINT4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x464U))
#define C2FIFOINT4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x468U))
#define C2FIFOINT4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x46CU))
#define C2FIFOUA4 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x470U))
#define C2FIFOUA4bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x470U))
#define C2FIFOUA4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x474U))
#define C2FIFOUA4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x478U))
#define C2FIFOUA4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x47CU))
#define C2FIFOCI4 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x480U))
#define C2FIFOCI4bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x480U))
#define C2FIFOCI4CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x484U))
#define C2FIFOCI4SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x488U))
#define C2FIFOCI4INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x48CU))
#define C2FIFOCON5 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x490U))
#define C2FIFOCON5bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x490U))
#define C2FIFOCON5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x494U))
#define C2FIFOCON5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x498U))
#define C2FIFOCON5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x49CU))
#define C2FIFOINT5 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4A0U))
#define C2FIFOINT5bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4A0U))
#define C2FIFOINT5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4A4U))
#define C2FIFOINT5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4A8U))
#define C2FIFOINT5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4ACU))
#define C2FIFOUA5 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4B0U))
#define C2FIFOUA5bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4B0U))
#define C2FIFOUA5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4B4U))
#define C2FIFOUA5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4B8U))
#define C2FIFOUA5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4BCU))
#define C2FIFOCI5 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4C0U))
#define C2FIFOCI5bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4C0U))
#define C2FIFOCI5CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4C4U))
#define C2FIFOCI5SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4C8U))
#define C2FIFOCI5INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4CCU))
#define C2FIFOCON6 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4D0U))
#define C2FIFOCON6bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4D0U))
#define C2FIFOCON6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4D4U))
#define C2FIFOCON6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4D8U))
#define C2FIFOCON6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4DCU))
#define C2FIFOINT6 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4E0U))
#define C2FIFOINT6bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4E0U))
#define C2FIFOINT6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4E4U))
#define C2FIFOINT6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4E8U))
#define C2FIFOINT6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4ECU))
#define C2FIFOUA6 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4F0U))
#define C2FIFOUA6bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4F0U))
#define C2FIFOUA6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4F4U))
#define C2FIFOUA6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4F8U))
#define C2FIFOUA6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x4FCU))
#define C2FIFOCI6 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x500U))
#define C2FIFOCI6bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x500U))
#define C2FIFOCI6CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x504U))
#define C2FIFOCI6SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x508U))
#define C2FIFOCI6INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x50CU))
#define C2FIFOCON7 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x510U))
#define C2FIFOCON7bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x510U))
#define C2FIFOCON7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x514U))
#define C2FIFOCON7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x518U))
#define C2FIFOCON7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x51CU))
#define C2FIFOINT7 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x520U))
#define C2FIFOINT7bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x520U))
#define C2FIFOINT7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x524U))
#define C2FIFOINT7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x528U))
#define C2FIFOINT7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x52CU))
#define C2FIFOUA7 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x530U))
#define C2FIFOUA7bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x530U))
#define C2FIFOUA7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x534U))
#define C2FIFOUA7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x538U))
#define C2FIFOUA7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x53CU))
#define C2FIFOCI7 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x540U))
#define C2FIFOCI7bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x540U))
#define C2FIFOCI7CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x544U))
#define C2FIFOCI7SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x548U))
#define C2FIFOCI7INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x54CU))
#define C2FIFOCON8 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x550U))
#define C2FIFOCON8bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x550U))
#define C2FIFOCON8CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x554U))
#define C2FIFOCON8SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x558U))
#define C2FIFOCON8INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x55CU))
#define C2FIFOINT8 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x560U))
#define C2FIFOINT8bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x560U))
#define C2FIFOINT8CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x564U))
#define C2FIFOINT8SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x568U))
#define C2FIFOINT8INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x56CU))
#define C2FIFOUA8 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x570U))
#define C2FIFOUA8bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x570U))
#define C2FIFOUA8CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x574U))
#define C2FIFOUA8SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x578U))
#define C2FIFOUA8INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x57CU))
#define C2FIFOCI8 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x580U))
#define C2FIFOCI8bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x580U))
#define C2FIFOCI8CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x584U))
#define C2FIFOCI8SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x588U))
#define C2FIFOCI8INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x58CU))
#define C2FIFOCON9 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x590U))
#define C2FIFOCON9bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x590U))
#define C2FIFOCON9CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x594U))
#define C2FIFOCON9SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x598U))
#define C2FIFOCON9INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x59CU))
#define C2FIFOINT9 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5A0U))
#define C2FIFOINT9bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5A0U))
#define C2FIFOINT9CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5A4U))
#define C2FIFOINT9SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5A8U))
#define C2FIFOINT9INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5ACU))
#define C2FIFOUA9 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5B0U))
#define C2FIFOUA9bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5B0U))
#define C2FIFOUA9CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5B4U))
#define C2FIFOUA9SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5B8U))
#define C2FIFOUA9INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5BCU))
#define C2FIFOCI9 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5C0U))
#define C2FIFOCI9bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5C0U))
#define C2FIFOCI9CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5C4U))
#define C2FIFOCI9SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5C8U))
#define C2FIFOCI9INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5CCU))
#define C2FIFOCON10 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5D0U))
#define C2FIFOCON10bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5D0U))
#define C2FIFOCON10CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5D4U))
#define C2FIFOCON10SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5D8U))
#define C2FIFOCON10INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5DCU))
#define C2FIFOINT10 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5E0U))
#define C2FIFOINT10bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5E0U))
#define C2FIFOINT10CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5E4U))
#define C2FIFOINT10SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5E8U))
#define C2FIFOINT10INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5ECU))
#define C2FIFOUA10 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5F0U))
#define C2FIFOUA10bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5F0U))
#define C2FIFOUA10CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5F4U))
#define C2FIFOUA10SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5F8U))
#define C2FIFOUA10INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x5FCU))
#define C2FIFOCI10 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x600U))
#define C2FIFOCI10bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x600U))
#define C2FIFOCI10CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x604U))
#define C2FIFOCI10SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x608U))
#define C2FIFOCI10INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x60CU))
#define C2FIFOCON11 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x610U))
#define C2FIFOCON11bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x610U))
#define C2FIFOCON11CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x614U))
#define C2FIFOCON11SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x618U))
#define C2FIFOCON11INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x61CU))
#define C2FIFOINT11 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x620U))
#define C2FIFOINT11bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x620U))
#define C2FIFOINT11CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x624U))
#define C2FIFOINT11SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x628U))
#define C2FIFOINT11INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x62CU))
#define C2FIFOUA11 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x630U))
#define C2FIFOUA11bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x630U))
#define C2FIFOUA11CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x634U))
#define C2FIFOUA11SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x638U))
#define C2FIFOUA11INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x63CU))
#define C2FIFOCI11 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x640U))
#define C2FIFOCI11bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x640U))
#define C2FIFOCI11CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x644U))
#define C2FIFOCI11SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x648U))
#define C2FIFOCI11INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x64CU))
#define C2FIFOCON12 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x650U))
#define C2FIFOCON12bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x650U))
#define C2FIFOCON12CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x654U))
#define C2FIFOCON12SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x658U))
#define C2FIFOCON12INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x65CU))
#define C2FIFOINT12 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x660U))
#define C2FIFOINT12bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x660U))
#define C2FIFOINT12CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x664U))
#define C2FIFOINT12SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x668U))
#define C2FIFOINT12INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x66CU))
#define C2FIFOUA12 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x670U))
#define C2FIFOUA12bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x670U))
#define C2FIFOUA12CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x674U))
#define C2FIFOUA12SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x678U))
#define C2FIFOUA12INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x67CU))
#define C2FIFOCI12 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x680U))
#define C2FIFOCI12bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x680U))
#define C2FIFOCI12CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x684U))
#define C2FIFOCI12SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x688U))
#define C2FIFOCI12INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x68CU))
#define C2FIFOCON13 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x690U))
#define C2FIFOCON13bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x690U))
#define C2FIFOCON13CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x694U))
#define C2FIFOCON13SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x698U))
#define C2FIFOCON13INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x69CU))
#define C2FIFOINT13 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6A0U))
#define C2FIFOINT13bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6A0U))
#define C2FIFOINT13CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6A4U))
#define C2FIFOINT13SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6A8U))
#define C2FIFOINT13INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6ACU))
#define C2FIFOUA13 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6B0U))
#define C2FIFOUA13bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6B0U))
#define C2FIFOUA13CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6B4U))
#define C2FIFOUA13SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6B8U))
#define C2FIFOUA13INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6BCU))
#define C2FIFOCI13 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6C0U))
#define C2FIFOCI13bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6C0U))
#define C2FIFOCI13CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6C4U))
#define C2FIFOCI13SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6C8U))
#define C2FIFOCI13INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6CCU))
#define C2FIFOCON14 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6D0U))
#define C2FIFOCON14bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6D0U))
#define C2FIFOCON14CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6D4U))
#define C2FIFOCON14SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6D8U))
#define C2FIFOCON14INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6DCU))
#define C2FIFOINT14 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6E0U))
#define C2FIFOINT14bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6E0U))
#define C2FIFOINT14CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6E4U))
#define C2FIFOINT14SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6E8U))
#define C2FIFOINT14INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6ECU))
#define C2FIFOUA14 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6F0U))
#define C2FIFOUA14bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6F0U))
#define C2FIFOUA14CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6F4U))
#define C2FIFOUA14SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6F8U))
#define C2FIFOUA14INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x6FCU))
#define C2FIFOCI14 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x700U))
#define C2FIFOCI14bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x700U))
#define C2FIFOCI14CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x704U))
#define C2FIFOCI14SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x708U))
#define C2FIFOCI14INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x70CU))
#define C2FIFOCON15 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x710U))
#define C2FIFOCON15bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x710U))
#define C2FIFOCON15CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x714U))
#define C2FIFOCON15SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x718U))
#define C2FIFOCON15INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x71CU))
#define C2FIFOINT15 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x720U))
#define C2FIFOINT15bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x720U))
#define C2FIFOINT15CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x724U))
#define C2FIFOINT15SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x728U))
#define C2FIFOINT15INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x72CU))
#define C2FIFOUA15 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x730U))
#define C2FIFOUA15bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x730U))
#define C2FIFOUA15CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x734U))
#define C2FIFOUA15SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x738U))
#define C2FIFOUA15INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x73CU))
#define C2FIFOCI15 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x740U))
#define C2FIFOCI15bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x740U))
#define C2FIFOCI15CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x744U))
#define C2FIFOCI15SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x748U))
#define C2FIFOCI15INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x74CU))
#define C2FIFOCON16 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x750U))
#define C2FIFOCON16bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x750U))
#define C2FIFOCON16CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x754U))
#define C2FIFOCON16SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x758U))
#define C2FIFOCON16INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x75CU))
#define C2FIFOINT16 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x760U))
#define C2FIFOINT16bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x760U))
#define C2FIFOINT16CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x764U))
#define C2FIFOINT16SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x768U))
#define C2FIFOINT16INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x76CU))
#define C2FIFOUA16 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x770U))
#define C2FIFOUA16bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x770U))
#define C2FIFOUA16CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x774U))
#define C2FIFOUA16SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x778U))
#define C2FIFOUA16INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x77CU))
#define C2FIFOCI16 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x780U))
#define C2FIFOCI16bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x780U))
#define C2FIFOCI16CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x784U))
#define C2FIFOCI16SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x788U))
#define C2FIFOCI16INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x78CU))
#define C2FIFOCON17 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x790U))
#define C2FIFOCON17bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x790U))
#define C2FIFOCON17CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x794U))
#define C2FIFOCON17SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x798U))
#define C2FIFOCON17INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x79CU))
#define C2FIFOINT17 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7A0U))
#define C2FIFOINT17bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7A0U))
#define C2FIFOINT17CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7A4U))
#define C2FIFOINT17SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7A8U))
#define C2FIFOINT17INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7ACU))
#define C2FIFOUA17 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7B0U))
#define C2FIFOUA17bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7B0U))
#define C2FIFOUA17CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7B4U))
#define C2FIFOUA17SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7B8U))
#define C2FIFOUA17INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7BCU))
#define C2FIFOCI17 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7C0U))
#define C2FIFOCI17bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7C0U))
#define C2FIFOCI17CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7C4U))
#define C2FIFOCI17SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7C8U))
#define C2FIFOCI17INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7CCU))
#define C2FIFOCON18 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7D0U))
#define C2FIFOCON18bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7D0U))
#define C2FIFOCON18CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7D4U))
#define C2FIFOCON18SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7D8U))
#define C2FIFOCON18INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7DCU))
#define C2FIFOINT18 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7E0U))
#define C2FIFOINT18bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7E0U))
#define C2FIFOINT18CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7E4U))
#define C2FIFOINT18SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7E8U))
#define C2FIFOINT18INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7ECU))
#define C2FIFOUA18 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7F0U))
#define C2FIFOUA18bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7F0U))
#define C2FIFOUA18CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7F4U))
#define C2FIFOUA18SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7F8U))
#define C2FIFOUA18INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x7FCU))
#define C2FIFOCI18 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x800U))
#define C2FIFOCI18bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x800U))
#define C2FIFOCI18CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x804U))
#define C2FIFOCI18SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x808U))
#define C2FIFOCI18INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x80CU))
#define C2FIFOCON19 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x810U))
#define C2FIFOCON19bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x810U))
#define C2FIFOCON19CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x814U))
#define C2FIFOCON19SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x818U))
#define C2FIFOCON19INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x81CU))
#define C2FIFOINT19 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x820U))
#define C2FIFOINT19bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x820U))
#define C2FIFOINT19CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x824U))
#define C2FIFOINT19SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x828U))
#define C2FIFOINT19INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x82CU))
#define C2FIFOUA19 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x830U))
#define C2FIFOUA19bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x830U))
#define C2FIFOUA19CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x834U))
#define C2FIFOUA19SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x838U))
#define C2FIFOUA19INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x83CU))
#define C2FIFOCI19 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x840U))
#define C2FIFOCI19bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x840U))
#define C2FIFOCI19CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x844U))
#define C2FIFOCI19SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x848U))
#define C2FIFOCI19INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x84CU))
#define C2FIFOCON20 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x850U))
#define C2FIFOCON20bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x850U))
#define C2FIFOCON20CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x854U))
#define C2FIFOCON20SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x858U))
#define C2FIFOCON20INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x85CU))
#define C2FIFOINT20 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x860U))
#define C2FIFOINT20bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x860U))
#define C2FIFOINT20CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x864U))
#define C2FIFOINT20SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x868U))
#define C2FIFOINT20INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x86CU))
#define C2FIFOUA20 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x870U))
#define C2FIFOUA20bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x870U))
#define C2FIFOUA20CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x874U))
#define C2FIFOUA20SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x878U))
#define C2FIFOUA20INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x87CU))
#define C2FIFOCI20 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x880U))
#define C2FIFOCI20bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x880U))
#define C2FIFOCI20CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x884U))
#define C2FIFOCI20SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x888U))
#define C2FIFOCI20INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x88CU))
#define C2FIFOCON21 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x890U))
#define C2FIFOCON21bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x890U))
#define C2FIFOCON21CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x894U))
#define C2FIFOCON21SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x898U))
#define C2FIFOCON21INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x89CU))
#define C2FIFOINT21 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8A0U))
#define C2FIFOINT21bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8A0U))
#define C2FIFOINT21CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8A4U))
#define C2FIFOINT21SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8A8U))
#define C2FIFOINT21INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8ACU))
#define C2FIFOUA21 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8B0U))
#define C2FIFOUA21bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8B0U))
#define C2FIFOUA21CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8B4U))
#define C2FIFOUA21SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8B8U))
#define C2FIFOUA21INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8BCU))
#define C2FIFOCI21 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8C0U))
#define C2FIFOCI21bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8C0U))
#define C2FIFOCI21CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8C4U))
#define C2FIFOCI21SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8C8U))
#define C2FIFOCI21INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8CCU))
#define C2FIFOCON22 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8D0U))
#define C2FIFOCON22bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8D0U))
#define C2FIFOCON22CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8D4U))
#define C2FIFOCON22SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8D8U))
#define C2FIFOCON22INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8DCU))
#define C2FIFOINT22 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8E0U))
#define C2FIFOINT22bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8E0U))
#define C2FIFOINT22CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8E4U))
#define C2FIFOINT22SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8E8U))
#define C2FIFOINT22INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8ECU))
#define C2FIFOUA22 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8F0U))
#define C2FIFOUA22bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8F0U))
#define C2FIFOUA22CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8F4U))
#define C2FIFOUA22SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8F8U))
#define C2FIFOUA22INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x8FCU))
#define C2FIFOCI22 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x900U))
#define C2FIFOCI22bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x900U))
#define C2FIFOCI22CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x904U))
#define C2FIFOCI22SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x908U))
#define C2FIFOCI22INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x90CU))
#define C2FIFOCON23 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x910U))
#define C2FIFOCON23bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x910U))
#define C2FIFOCON23CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x914U))
#define C2FIFOCON23SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x918U))
#define C2FIFOCON23INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x91CU))
#define C2FIFOINT23 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x920U))
#define C2FIFOINT23bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x920U))
#define C2FIFOINT23CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x924U))
#define C2FIFOINT23SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x928U))
#define C2FIFOINT23INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x92CU))
#define C2FIFOUA23 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x930U))
#define C2FIFOUA23bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x930U))
#define C2FIFOUA23CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x934U))
#define C2FIFOUA23SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x938U))
#define C2FIFOUA23INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x93CU))
#define C2FIFOCI23 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x940U))
#define C2FIFOCI23bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x940U))
#define C2FIFOCI23CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x944U))
#define C2FIFOCI23SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x948U))
#define C2FIFOCI23INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x94CU))
#define C2FIFOCON24 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x950U))
#define C2FIFOCON24bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x950U))
#define C2FIFOCON24CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x954U))
#define C2FIFOCON24SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x958U))
#define C2FIFOCON24INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x95CU))
#define C2FIFOINT24 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x960U))
#define C2FIFOINT24bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x960U))
#define C2FIFOINT24CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x964U))
#define C2FIFOINT24SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x968U))
#define C2FIFOINT24INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x96CU))
#define C2FIFOUA24 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x970U))
#define C2FIFOUA24bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x970U))
#define C2FIFOUA24CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x974U))
#define C2FIFOUA24SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x978U))
#define C2FIFOUA24INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x97CU))
#define C2FIFOCI24 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x980U))
#define C2FIFOCI24bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x980U))
#define C2FIFOCI24CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x984U))
#define C2FIFOCI24SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x988U))
#define C2FIFOCI24INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x98CU))
#define C2FIFOCON25 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x990U))
#define C2FIFOCON25bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x990U))
#define C2FIFOCON25CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x994U))
#define C2FIFOCON25SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x998U))
#define C2FIFOCON25INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x99CU))
#define C2FIFOINT25 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9A0U))
#define C2FIFOINT25bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9A0U))
#define C2FIFOINT25CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9A4U))
#define C2FIFOINT25SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9A8U))
#define C2FIFOINT25INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9ACU))
#define C2FIFOUA25 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9B0U))
#define C2FIFOUA25bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9B0U))
#define C2FIFOUA25CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9B4U))
#define C2FIFOUA25SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9B8U))
#define C2FIFOUA25INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9BCU))
#define C2FIFOCI25 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9C0U))
#define C2FIFOCI25bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9C0U))
#define C2FIFOCI25CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9C4U))
#define C2FIFOCI25SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9C8U))
#define C2FIFOCI25INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9CCU))
#define C2FIFOCON26 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9D0U))
#define C2FIFOCON26bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9D0U))
#define C2FIFOCON26CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9D4U))
#define C2FIFOCON26SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9D8U))
#define C2FIFOCON26INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9DCU))
#define C2FIFOINT26 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9E0U))
#define C2FIFOINT26bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9E0U))
#define C2FIFOINT26CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9E4U))
#define C2FIFOINT26SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9E8U))
#define C2FIFOINT26INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9ECU))
#define C2FIFOUA26 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9F0U))
#define C2FIFOUA26bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9F0U))
#define C2FIFOUA26CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9F4U))
#define C2FIFOUA26SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9F8U))
#define C2FIFOUA26INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0x9FCU))
#define C2FIFOCI26 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA00U))
#define C2FIFOCI26bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA00U))
#define C2FIFOCI26CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA04U))
#define C2FIFOCI26SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA08U))
#define C2FIFOCI26INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA0CU))
#define C2FIFOCON27 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA10U))
#define C2FIFOCON27bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA10U))
#define C2FIFOCON27CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA14U))
#define C2FIFOCON27SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA18U))
#define C2FIFOCON27INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA1CU))
#define C2FIFOINT27 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA20U))
#define C2FIFOINT27bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA20U))
#define C2FIFOINT27CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA24U))
#define C2FIFOINT27SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA28U))
#define C2FIFOINT27INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA2CU))
#define C2FIFOUA27 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA30U))
#define C2FIFOUA27bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA30U))
#define C2FIFOUA27CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA34U))
#define C2FIFOUA27SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA38U))
#define C2FIFOUA27INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA3CU))
#define C2FIFOCI27 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA40U))
#define C2FIFOCI27bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA40U))
#define C2FIFOCI27CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA44U))
#define C2FIFOCI27SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA48U))
#define C2FIFOCI27INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA4CU))
#define C2FIFOCON28 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA50U))
#define C2FIFOCON28bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA50U))
#define C2FIFOCON28CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA54U))
#define C2FIFOCON28SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA58U))
#define C2FIFOCON28INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA5CU))
#define C2FIFOINT28 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA60U))
#define C2FIFOINT28bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA60U))
#define C2FIFOINT28CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA64U))
#define C2FIFOINT28SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA68U))
#define C2FIFOINT28INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA6CU))
#define C2FIFOUA28 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA70U))
#define C2FIFOUA28bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA70U))
#define C2FIFOUA28CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA74U))
#define C2FIFOUA28SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA78U))
#define C2FIFOUA28INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA7CU))
#define C2FIFOCI28 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA80U))
#define C2FIFOCI28bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA80U))
#define C2FIFOCI28CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA84U))
#define C2FIFOCI28SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA88U))
#define C2FIFOCI28INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA8CU))
#define C2FIFOCON29 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA90U))
#define C2FIFOCON29bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA90U))
#define C2FIFOCON29CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA94U))
#define C2FIFOCON29SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA98U))
#define C2FIFOCON29INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xA9CU))
#define C2FIFOINT29 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAA0U))
#define C2FIFOINT29bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAA0U))
#define C2FIFOINT29CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAA4U))
#define C2FIFOINT29SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAA8U))
#define C2FIFOINT29INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAACU))
#define C2FIFOUA29 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAB0U))
#define C2FIFOUA29bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAB0U))
#define C2FIFOUA29CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAB4U))
#define C2FIFOUA29SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAB8U))
#define C2FIFOUA29INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xABCU))
#define C2FIFOCI29 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAC0U))
#define C2FIFOCI29bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAC0U))
#define C2FIFOCI29CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAC4U))
#define C2FIFOCI29SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAC8U))
#define C2FIFOCI29INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xACCU))
#define C2FIFOCON30 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAD0U))
#define C2FIFOCON30bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAD0U))
#define C2FIFOCON30CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAD4U))
#define C2FIFOCON30SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAD8U))
#define C2FIFOCON30INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xADCU))
#define C2FIFOINT30 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAE0U))
#define C2FIFOINT30bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAE0U))
#define C2FIFOINT30CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAE4U))
#define C2FIFOINT30SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAE8U))
#define C2FIFOINT30INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAECU))
#define C2FIFOUA30 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAF0U))
#define C2FIFOUA30bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAF0U))
#define C2FIFOUA30CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAF4U))
#define C2FIFOUA30SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAF8U))
#define C2FIFOUA30INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xAFCU))
#define C2FIFOCI30 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB00U))
#define C2FIFOCI30bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB00U))
#define C2FIFOCI30CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB04U))
#define C2FIFOCI30SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB08U))
#define C2FIFOCI30INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB0CU))
#define C2FIFOCON31 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB10U))
#define C2FIFOCON31bits (*(const volatile pic32_can_fifo_con_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB10U))
#define C2FIFOCON31CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB14U))
#define C2FIFOCON31SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB18U))
#define C2FIFOCON31INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB1CU))
#define C2FIFOINT31 (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB20U))
#define C2FIFOINT31bits (*(const volatile pic32_can_fifo_int_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB20U))
#define C2FIFOINT31CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB24U))
#define C2FIFOINT31SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB28U))
#define C2FIFOINT31INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB2CU))
#define C2FIFOUA31 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB30U))
#define C2FIFOUA31bits (*(const volatile pic32_can_fifo_ua_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB30U))
#define C2FIFOUA31CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB34U))
#define C2FIFOUA31SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB38U))
#define C2FIFOUA31INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB3CU))
#define C2FIFOCI31 (*(const volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB40U))
#define C2FIFOCI31bits (*(const volatile pic32_can_fifo_ci_bits_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB40U))
#define C2FIFOCI31CLR (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB44U))
#define C2FIFOCI31SET (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB48U))
#define C2FIFOCI31INV (*(volatile uint32_t *)((uintptr_t)PIC32_CAN_C2_BASE + 0xB4CU))
#endif
#endif

#ifdef __cplusplus
}
#endif

#endif /* PIC32_CAN_H */
