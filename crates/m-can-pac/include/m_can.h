/* Bosch M_CAN: registers and message layouts.
 * CAN FD controller as a synthesizable block: CAN core, Tx and Rx Handler, two interrupt lines and an external
 * Message RAM of 32-bit words that holds filters, received messages, messages to send and transmit events. Base
 * addresses, interrupt numbers, clock frequencies and the number of instances belong to the device it is built
 * into.
 * Described after M_CAN Controller Area Network User's Manual, Robert Bosch GmbH, Automotive Electronics,
 * revision 3.3.1.
 * Generated from the description of the controller; changes belong there.
 * C99 or C++11. A field FIELD of a register REG has M_CAN_REG_FIELD_Pos, _Msk, _Width and _Access; a field that
 * is repeated in its register takes the number of the lane, counted from 0, as an argument.
 * Access codes: rw, ro, wo; w1c and w0c are flags cleared by writing 1 or 0; w1s is a request made by writing 1;
 * rwhc a request that 0 withdraws; rwh is changed by hardware too; wclr is cleared or preset by any write; +rc
 * and +rs are cleared or set by a read, @n of byte n; a condition for writing stands behind the colon.
 * Define M_CAN_ASSERT(condition) to have ranges and indices checked at run time.
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef M_CAN_H
#define M_CAN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__cplusplus)
#define M_CAN_STATIC_ASSERT(condition, name) static_assert(condition, #name)
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define M_CAN_STATIC_ASSERT(condition, name) _Static_assert(condition, #name)
#else
#define M_CAN_STATIC_ASSERT(condition, name) typedef char name[(condition) ? 1 : -1]
#endif

#ifndef M_CAN_ASSERT
#define M_CAN_ASSERT(condition) ((void)0)
#endif

/* A register that software can only read. C++ wants every const member initialized. */
#ifdef __cplusplus
#define M_CAN_READ_ONLY volatile
#else
#define M_CAN_READ_ONLY volatile const
#endif

/* Values of PSR.DLEC, PSR.LEC.
 * Kind of the last protocol error, used by the arbitration phase (LEC) and the data phase (DLEC).
 * §2.3.14 p.18
 */
/* Nothing went wrong since a message was last received or sent without error. */
#define M_CAN_LAST_ERROR_CODE_NO_ERROR 0U
/* More than five equal bits in a row in a part of a received message that is bit stuffed. */
#define M_CAN_LAST_ERROR_CODE_STUFF_ERROR 1U
/* A received frame violates its fixed format; a wrong fixed stuff bit in a CAN FD CRC counts here as well. */
#define M_CAN_LAST_ERROR_CODE_FORM_ERROR 2U
/* No other node acknowledged the transmitted message. */
#define M_CAN_LAST_ERROR_CODE_ACK_ERROR 3U
/* Sent recessive outside the arbitration field, but the bus was dominant. */
#define M_CAN_LAST_ERROR_CODE_BIT1_ERROR 4U
/* Sent dominant, but the bus was recessive. During Bus_Off recovery it marks each sequence of 11 recessive bits. */
#define M_CAN_LAST_ERROR_CODE_BIT0_ERROR 5U
/* The CRC of a received message does not match its data. */
#define M_CAN_LAST_ERROR_CODE_CRC_ERROR 6U
/* No CAN bus event since the code was last read. */
#define M_CAN_LAST_ERROR_CODE_NO_CHANGE 7U

/* Values of PSR.ACT.
 * What the node is doing on the bus.
 * §2.3.14 p.18
 */
/* Waiting for 11 recessive bits, also after a protocol exception event. */
#define M_CAN_ACTIVITY_SYNCHRONIZING 0U
/* Neither receiver nor transmitter. */
#define M_CAN_ACTIVITY_IDLE 1U
/* Receiving. */
#define M_CAN_ACTIVITY_RECEIVER 2U
/* Transmitting. */
#define M_CAN_ACTIVITY_TRANSMITTER 3U

/* Values of ILS.ARAL, ILS.PEDL, ILS.PEAL, ILS.WDIL, ILS.BOL, ILS.EWL, ILS.EPL, ILS.ELOL, ILS.BEUL, ILS.BECL,
 * ILS.DRXL, ILS.TOOL, ILS.MRAFL, ILS.TSWL, ILS.TEFLL, ILS.TEFFL, ILS.TEFWL, ILS.TEFNL, ILS.TFEL, ILS.TCFL,
 * ILS.TCL, ILS.HPML, ILS.RF1LL, ILS.RF1FL, ILS.RF1WL, ILS.RF1NL, ILS.RF0LL, ILS.RF0FL, ILS.RF0WL, ILS.RF0NL.
 * The interrupt line a flag is routed to.
 * §2.3.18 p.25
 */
/* Line m_can_int0. */
#define M_CAN_INTERRUPT_LINE_INT0 0U
/* Line m_can_int1. */
#define M_CAN_INTERRUPT_LINE_INT1 1U

/* Values of GFC.ANFS, GFC.ANFE.
 * Destination of a frame that matches no filter element.
 * §2.3.20 p.27
 */
/* Stored in Rx FIFO 0. */
#define M_CAN_NON_MATCHING_RX_FIFO_0 0U
/* Stored in Rx FIFO 1. */
#define M_CAN_NON_MATCHING_RX_FIFO_1 1U
/* Discarded. */
#define M_CAN_NON_MATCHING_REJECT 2U
/* Discarded, the same as code 2. */
#define M_CAN_NON_MATCHING_REJECT_ALT 3U

/* Values of GFC.RRFS, GFC.RRFE.
 * What happens to remote frames.
 * §2.3.20 p.27
 */
/* Pass through the filter list like data frames. */
#define M_CAN_REMOTE_FRAMES_FILTER 0U
/* All are discarded. */
#define M_CAN_REMOTE_FRAMES_REJECT 1U

/* Values of RXF0C.F0OM, RXF1C.F1OM.
 * What a full Rx FIFO does with the next message.
 * §2.3.27 p.31; §3.4.2.1 p.70; §3.4.2.2 p.70
 */
/* The new message is discarded and reported lost. */
#define M_CAN_FIFO_MODE_BLOCKING 0U
/* The new message replaces the oldest one; put and get index both advance. */
#define M_CAN_FIFO_MODE_OVERWRITE 1U

/* Values of RXESC.RBDS, RXESC.F1DS, RXESC.F0DS, TXESC.TBDS.
 * Bytes of the data field of an element in Message RAM. An element is two words longer than its data field.
 * §2.3.34 p.36; Table 55 p.69; Table 59 p.75
 */
/* 8 bytes; the element has 4 words. */
#define M_CAN_DATA_FIELD_SIZE_BYTES_8 0U
/* 12 bytes; the element has 5 words. */
#define M_CAN_DATA_FIELD_SIZE_BYTES_12 1U
/* 16 bytes; the element has 6 words. */
#define M_CAN_DATA_FIELD_SIZE_BYTES_16 2U
/* 20 bytes; the element has 7 words. */
#define M_CAN_DATA_FIELD_SIZE_BYTES_20 3U
/* 24 bytes; the element has 8 words. */
#define M_CAN_DATA_FIELD_SIZE_BYTES_24 4U
/* 32 bytes; the element has 10 words. */
#define M_CAN_DATA_FIELD_SIZE_BYTES_32 5U
/* 48 bytes; the element has 14 words. */
#define M_CAN_DATA_FIELD_SIZE_BYTES_48 6U
/* 64 bytes; the element has 18 words. */
#define M_CAN_DATA_FIELD_SIZE_BYTES_64 7U

/* Identifier length of a frame.
 * §2.4.2 p.47; §2.4.3 p.49; §2.4.4 p.51
 */
/* 11-bit identifier. */
#define M_CAN_ID_FORMAT_STANDARD 0U
/* 29-bit identifier. */
#define M_CAN_ID_FORMAT_EXTENDED 1U

/* Data frame or remote frame.
 * §2.4.2 p.47; §2.4.3 p.49; §2.4.4 p.51
 */
/* Data frame. */
#define M_CAN_FRAME_KIND_DATA 0U
/* Remote frame. */
#define M_CAN_FRAME_KIND_REMOTE 1U

/* Frame format.
 * §2.4.2 p.48; §2.4.3 p.50; §2.4.4 p.52
 */
/* Classical CAN. */
#define M_CAN_FRAME_FORMAT_CLASSIC 0U
/* CAN FD, with its own DLC coding and CRC. */
#define M_CAN_FRAME_FORMAT_FD 1U

/* Error state of the node that transmitted a frame.
 * §2.4.2 p.47; §2.4.4 p.51
 */
/* The transmitter was error active. */
#define M_CAN_ERROR_STATE_ERROR_ACTIVE 0U
/* The transmitter was error passive. */
#define M_CAN_ERROR_STATE_ERROR_PASSIVE 1U

/* Number of data bytes of a frame. Codes 0 to 8 are the same in both formats. Name and number of the codes 9 to
 * 15 are those of CAN FD; in Classical CAN they all mean 8 bytes.
 * §2.4.2 p.48; §2.4.3 p.50; §2.4.4 p.52; Table 54 p.59
 */
#define M_CAN_DATA_LENGTH_CODE_BYTES_0 0U
#define M_CAN_DATA_LENGTH_CODE_BYTES_1 1U
#define M_CAN_DATA_LENGTH_CODE_BYTES_2 2U
#define M_CAN_DATA_LENGTH_CODE_BYTES_3 3U
#define M_CAN_DATA_LENGTH_CODE_BYTES_4 4U
#define M_CAN_DATA_LENGTH_CODE_BYTES_5 5U
#define M_CAN_DATA_LENGTH_CODE_BYTES_6 6U
#define M_CAN_DATA_LENGTH_CODE_BYTES_7 7U
#define M_CAN_DATA_LENGTH_CODE_BYTES_8 8U
/* 12 bytes in CAN FD, 8 in Classical CAN. */
#define M_CAN_DATA_LENGTH_CODE_BYTES_12 9U
/* 16 bytes in CAN FD, 8 in Classical CAN. */
#define M_CAN_DATA_LENGTH_CODE_BYTES_16 10U
/* 20 bytes in CAN FD, 8 in Classical CAN. */
#define M_CAN_DATA_LENGTH_CODE_BYTES_20 11U
/* 24 bytes in CAN FD, 8 in Classical CAN. */
#define M_CAN_DATA_LENGTH_CODE_BYTES_24 12U
/* 32 bytes in CAN FD, 8 in Classical CAN. */
#define M_CAN_DATA_LENGTH_CODE_BYTES_32 13U
/* 48 bytes in CAN FD, 8 in Classical CAN. */
#define M_CAN_DATA_LENGTH_CODE_BYTES_48 14U
/* 64 bytes in CAN FD, 8 in Classical CAN. */
#define M_CAN_DATA_LENGTH_CODE_BYTES_64 15U

/* What a match of a filter element does. The first matching enabled element ends the filtering of a message.
 * §2.4.5 p.53; §2.4.6 p.54
 */
/* The element is skipped. */
#define M_CAN_FILTER_ACTION_DISABLED 0U
/* Store in Rx FIFO 0. */
#define M_CAN_FILTER_ACTION_FIFO_0 1U
/* Store in Rx FIFO 1. */
#define M_CAN_FILTER_ACTION_FIFO_1 2U
/* Discard the message. Not meant for Sync messages. */
#define M_CAN_FILTER_ACTION_REJECT 3U
/* Report a high priority message without storing it. Not meant for Sync messages. */
#define M_CAN_FILTER_ACTION_PRIORITY 4U
/* Report a high priority message and store it in Rx FIFO 0. */
#define M_CAN_FILTER_ACTION_PRIORITY_FIFO_0 5U
/* Report a high priority message and store it in Rx FIFO 1. */
#define M_CAN_FILTER_ACTION_PRIORITY_FIFO_1 6U
/* Store in a dedicated Rx Buffer or as debug message. The filter type is ignored: the first ID has to match
 * exactly.
 */
#define M_CAN_FILTER_ACTION_RX_BUFFER 7U

/* What a filter element of action rx_buffer does with its message (ID2 bits 10 and 9).
 * §2.4.5 p.53; §2.4.6 p.55
 */
/* Store in a dedicated Rx Buffer. */
#define M_CAN_RX_BUFFER_USE_RX_BUFFER 0U
/* Debug message A. */
#define M_CAN_RX_BUFFER_USE_DEBUG_A 1U
/* Debug message B. */
#define M_CAN_RX_BUFFER_USE_DEBUG_B 2U
/* Debug message C. */
#define M_CAN_RX_BUFFER_USE_DEBUG_C 3U

/* How the two IDs of a standard filter element are compared. Ignored when the action is rx_buffer.
 * §2.4.5 p.52; §3.4.1.2 p.66; §3.4.1.3 p.66
 */
/* Identifiers from SFID1 to SFID2, with SFID2 not less than SFID1. */
#define M_CAN_STANDARD_FILTER_TYPE_RANGE 0U
/* The two identifiers SFID1 and SFID2; equal ones give a filter for a single identifier. */
#define M_CAN_STANDARD_FILTER_TYPE_DUAL 1U
/* SFID1 is the identifier, SFID2 the mask: bits with mask 0 do not count. */
#define M_CAN_STANDARD_FILTER_TYPE_CLASSIC 2U
/* The element is skipped. */
#define M_CAN_STANDARD_FILTER_TYPE_DISABLED 3U

/* How the two IDs of an extended filter element are compared. Ignored when the action is rx_buffer.
 * §2.4.6 p.54; §3.4.1.1 p.66; §3.4.1.3 p.66; §3.4.1.5 p.68
 */
/* Received identifier ANDed with XIDAM, from EFID1 to EFID2, with EFID2 not less than EFID1. */
#define M_CAN_EXTENDED_FILTER_TYPE_RANGE 0U
/* The two identifiers EFID1 and EFID2, compared with the received one ANDed with XIDAM. */
#define M_CAN_EXTENDED_FILTER_TYPE_DUAL 1U
/* EFID1 is the identifier, EFID2 the mask: bits with mask 0 do not count. The received identifier is ANDed with
 * XIDAM first.
 */
#define M_CAN_EXTENDED_FILTER_TYPE_CLASSIC 2U
/* As range, but XIDAM is not applied. */
#define M_CAN_EXTENDED_FILTER_TYPE_RANGE_UNMASKED 3U

/* Kind of a Tx event.
 * §2.4.4 p.52
 */
/* The message was sent. */
#define M_CAN_TX_EVENT_TYPE_TX_EVENT 1U
/* The message was sent although it had been cancelled; always in DAR mode. */
#define M_CAN_TX_EVENT_TYPE_IN_SPITE_OF_CANCELLATION 2U

/* Values of TEST.RX.
 * §2.3.5 Table 6 p.9; Table 1 p.5 (reset and access); §3.1.9 p.63
 */
#define M_CAN_TEST_RX_DOMINANT 0U
#define M_CAN_TEST_RX_RECESSIVE 1U

/* Values of TEST.TX.
 * §2.3.5 Table 6 p.9; Table 1 p.5 (reset and access); §3.1.9 p.63
 */
/* The CAN core drives the pin; it changes at the end of a bit time. */
#define M_CAN_TEST_TX_CORE 0U
/* The sample point can be watched at the pin. */
#define M_CAN_TEST_TX_SAMPLE_POINT 1U
/* The pin is held dominant. */
#define M_CAN_TEST_TX_DOMINANT 2U
/* The pin is held recessive. */
#define M_CAN_TEST_TX_RECESSIVE 3U

/* Values of CCCR.NISO.
 * §2.3.7 Table 8 p.11; Table 1 p.5 (reset and access); §3.1.1 p.57
 */
#define M_CAN_CCCR_NISO_ISO_11898_1 0U
#define M_CAN_CCCR_NISO_BOSCH_FD_V1 1U

/* Values of CCCR.WMM.
 * §2.3.7 Table 8 p.11; Table 1 p.5 (reset and access); §3.1.1 p.57
 */
/* 8-bit Message Markers; the Tx Event FIFO stores 16-bit timestamps. */
#define M_CAN_CCCR_WMM_BITS_8 0U
/* 16-bit Message Markers take the place of the internal timestamp in the Tx Event FIFO. */
#define M_CAN_CCCR_WMM_BITS_16 1U

/* Values of CCCR.UTSU.
 * §2.3.7 Table 8 p.11; Table 1 p.5 (reset and access); §3.1.1 p.57
 */
/* 16-bit timestamps of this module. */
#define M_CAN_CCCR_UTSU_INTERNAL 0U
/* Timestamps of an external Timestamping Unit (TSU). */
#define M_CAN_CCCR_UTSU_EXTERNAL 1U

/* Values of TSCC.TSS.
 * §2.3.9 Table 10 p.14; Table 1 p.5 (reset and access)
 */
/* The timestamp is always 0x0000. */
#define M_CAN_TSCC_TSS_ZERO 0U
/* Internal counter, incremented as TCP says. */
#define M_CAN_TSCC_TSS_INTERNAL 1U
/* External 16-bit timebase m_can_ext_ts. */
#define M_CAN_TSCC_TSS_EXTERNAL 2U
/* The timestamp is always 0x0000, the same as code 0. */
#define M_CAN_TSCC_TSS_ZERO_ALT 3U

/* Values of TOCC.TOS.
 * §2.3.11 Table 12 p.15; Table 1 p.5 (reset and access); §3.3 p.64
 */
/* Runs from the moment CCCR.INIT is cleared; a write to TOCV presets it. */
#define M_CAN_TOCC_TOS_CONTINUOUS 0U
/* Preset while the Tx Event FIFO is empty, runs once the first element is stored. */
#define M_CAN_TOCC_TOS_TX_EVENT_FIFO 1U
/* Preset while Rx FIFO 0 is empty, runs once the first element is stored. */
#define M_CAN_TOCC_TOS_RX_FIFO_0 2U
/* Preset while Rx FIFO 1 is empty, runs once the first element is stored. */
#define M_CAN_TOCC_TOS_RX_FIFO_1 3U

/* Values of HPMS.FLST.
 * §2.3.24 Table 25 p.29; Table 1 p.6 (reset and access); §3.1.1 p.57; §3.6 p.78
 */
#define M_CAN_HPMS_FLST_STANDARD 0U
#define M_CAN_HPMS_FLST_EXTENDED 1U

/* Values of HPMS.MSI.
 * §2.3.24 Table 25 p.29; Table 1 p.6 (reset and access); §3.1.1 p.57; §3.6 p.78
 */
/* No FIFO was selected. */
#define M_CAN_HPMS_MSI_NONE 0U
/* The message was lost at a FIFO. */
#define M_CAN_HPMS_MSI_MESSAGE_LOST 1U
/* Stored in Rx FIFO 0. */
#define M_CAN_HPMS_MSI_FIFO_0 2U
/* Stored in Rx FIFO 1. */
#define M_CAN_HPMS_MSI_FIFO_1 3U

/* Values of RXF1S.DMS.
 * §2.3.32 Table 33 p.34; §2.3.32 p.35; Table 1 p.6 (reset and access); §3.4.2 p.69; §3.1.1 p.57
 */
/* Waiting for debug messages; the DMA request is cleared. */
#define M_CAN_RXF1S_DMS_IDLE 0U
/* Debug message A received. */
#define M_CAN_RXF1S_DMS_A 1U
/* Debug messages A and B received. */
#define M_CAN_RXF1S_DMS_A_B 2U
/* Debug messages A, B and C received; the DMA request is set and their buffers are locked until it is
 * acknowledged.
 */
#define M_CAN_RXF1S_DMS_A_B_C 3U

/* Values of TXBC.TFQM.
 * §2.3.35 Table 36 p.37; Table 1 p.6 (reset and access); §3.5.5 p.76
 */
/* Tx FIFO: messages leave in the order in which they were written. */
#define M_CAN_TXBC_TFQM_FIFO 0U
/* Tx Queue: the message with the lowest identifier leaves first. */
#define M_CAN_TXBC_TFQM_QUEUE 1U

/* §2.4.3 Table 50 p.49 */
/* Recessive only if the node is error passive. */
#define M_CAN_TX_BUFFER_T0_ESI_BY_ERROR_STATE 0U
/* Always recessive. */
#define M_CAN_TX_BUFFER_T0_ESI_RECESSIVE 1U

/* The register block. */
typedef struct m_can_regs {
    M_CAN_READ_ONLY uint32_t CREL; /* Core Release Register */
    M_CAN_READ_ONLY uint32_t ENDN; /* Endian Register */
    volatile uint32_t CUST; /* Customer Register */
    volatile uint32_t DBTP; /* Data Bit Timing & Prescaler Register */
    volatile uint32_t TEST; /* Test Register */
    volatile uint32_t RWD; /* RAM Watchdog */
    volatile uint32_t CCCR; /* CC Control Register */
    volatile uint32_t NBTP; /* Nominal Bit Timing & Prescaler Register */
    volatile uint32_t TSCC; /* Timestamp Counter Configuration */
    volatile uint32_t TSCV; /* Timestamp Counter Value */
    volatile uint32_t TOCC; /* Timeout Counter Configuration */
    volatile uint32_t TOCV; /* Timeout Counter Value */
    uint8_t RESERVED_030[16];
    M_CAN_READ_ONLY uint32_t ECR; /* Error Counter Register */
    M_CAN_READ_ONLY uint32_t PSR; /* Protocol Status Register */
    volatile uint32_t TDCR; /* Transmitter Delay Compensation Register */
    uint8_t RESERVED_04C[4];
    volatile uint32_t IR; /* Interrupt Register */
    volatile uint32_t IE; /* Interrupt Enable */
    volatile uint32_t ILS; /* Interrupt Line Select */
    volatile uint32_t ILE; /* Interrupt Line Enable */
    uint8_t RESERVED_060[32];
    volatile uint32_t GFC; /* Global Filter Configuration */
    volatile uint32_t SIDFC; /* Standard ID Filter Configuration */
    volatile uint32_t XIDFC; /* Extended ID Filter Configuration */
    uint8_t RESERVED_08C[4];
    volatile uint32_t XIDAM; /* Extended ID AND Mask */
    M_CAN_READ_ONLY uint32_t HPMS; /* High Priority Message Status */
    volatile uint32_t NDAT1; /* New Data 1 */
    volatile uint32_t NDAT2; /* New Data 2 */
    volatile uint32_t RXF0C; /* Rx FIFO 0 Configuration */
    M_CAN_READ_ONLY uint32_t RXF0S; /* Rx FIFO 0 Status */
    volatile uint32_t RXF0A; /* Rx FIFO 0 Acknowledge */
    volatile uint32_t RXBC; /* Rx Buffer Configuration */
    volatile uint32_t RXF1C; /* Rx FIFO 1 Configuration */
    M_CAN_READ_ONLY uint32_t RXF1S; /* Rx FIFO 1 Status */
    volatile uint32_t RXF1A; /* Rx FIFO 1 Acknowledge */
    volatile uint32_t RXESC; /* Rx Buffer / FIFO Element Size Configuration */
    volatile uint32_t TXBC; /* Tx Buffer Configuration */
    M_CAN_READ_ONLY uint32_t TXFQS; /* Tx FIFO/Queue Status */
    volatile uint32_t TXESC; /* Tx Buffer Element Size Configuration */
    M_CAN_READ_ONLY uint32_t TXBRP; /* Tx Buffer Request Pending */
    volatile uint32_t TXBAR; /* Tx Buffer Add Request */
    volatile uint32_t TXBCR; /* Tx Buffer Cancellation Request */
    M_CAN_READ_ONLY uint32_t TXBTO; /* Tx Buffer Transmission Occurred */
    M_CAN_READ_ONLY uint32_t TXBCF; /* Tx Buffer Cancellation Finished */
    volatile uint32_t TXBTIE; /* Tx Buffer Transmission Interrupt Enable */
    volatile uint32_t TXBCIE; /* Tx Buffer Cancellation Finished Interrupt Enable */
    uint8_t RESERVED_0E8[8];
    volatile uint32_t TXEFC; /* Tx Event FIFO Configuration */
    M_CAN_READ_ONLY uint32_t TXEFS; /* Tx Event FIFO Status */
    volatile uint32_t TXEFA; /* Tx Event FIFO Acknowledge */
    uint8_t RESERVED_0FC[260];
} m_can_regs_t;

M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, CREL) == 0x000U, m_can_at_CREL);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, ENDN) == 0x004U, m_can_at_ENDN);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, CUST) == 0x008U, m_can_at_CUST);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, DBTP) == 0x00CU, m_can_at_DBTP);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TEST) == 0x010U, m_can_at_TEST);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, RWD) == 0x014U, m_can_at_RWD);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, CCCR) == 0x018U, m_can_at_CCCR);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, NBTP) == 0x01CU, m_can_at_NBTP);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TSCC) == 0x020U, m_can_at_TSCC);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TSCV) == 0x024U, m_can_at_TSCV);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TOCC) == 0x028U, m_can_at_TOCC);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TOCV) == 0x02CU, m_can_at_TOCV);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, ECR) == 0x040U, m_can_at_ECR);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, PSR) == 0x044U, m_can_at_PSR);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TDCR) == 0x048U, m_can_at_TDCR);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, IR) == 0x050U, m_can_at_IR);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, IE) == 0x054U, m_can_at_IE);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, ILS) == 0x058U, m_can_at_ILS);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, ILE) == 0x05CU, m_can_at_ILE);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, GFC) == 0x080U, m_can_at_GFC);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, SIDFC) == 0x084U, m_can_at_SIDFC);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, XIDFC) == 0x088U, m_can_at_XIDFC);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, XIDAM) == 0x090U, m_can_at_XIDAM);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, HPMS) == 0x094U, m_can_at_HPMS);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, NDAT1) == 0x098U, m_can_at_NDAT1);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, NDAT2) == 0x09CU, m_can_at_NDAT2);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, RXF0C) == 0x0A0U, m_can_at_RXF0C);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, RXF0S) == 0x0A4U, m_can_at_RXF0S);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, RXF0A) == 0x0A8U, m_can_at_RXF0A);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, RXBC) == 0x0ACU, m_can_at_RXBC);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, RXF1C) == 0x0B0U, m_can_at_RXF1C);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, RXF1S) == 0x0B4U, m_can_at_RXF1S);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, RXF1A) == 0x0B8U, m_can_at_RXF1A);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, RXESC) == 0x0BCU, m_can_at_RXESC);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXBC) == 0x0C0U, m_can_at_TXBC);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXFQS) == 0x0C4U, m_can_at_TXFQS);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXESC) == 0x0C8U, m_can_at_TXESC);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXBRP) == 0x0CCU, m_can_at_TXBRP);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXBAR) == 0x0D0U, m_can_at_TXBAR);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXBCR) == 0x0D4U, m_can_at_TXBCR);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXBTO) == 0x0D8U, m_can_at_TXBTO);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXBCF) == 0x0DCU, m_can_at_TXBCF);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXBTIE) == 0x0E0U, m_can_at_TXBTIE);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXBCIE) == 0x0E4U, m_can_at_TXBCIE);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXEFC) == 0x0F0U, m_can_at_TXEFC);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXEFS) == 0x0F4U, m_can_at_TXEFS);
M_CAN_STATIC_ASSERT(offsetof(m_can_regs_t, TXEFA) == 0x0F8U, m_can_at_TXEFA);
M_CAN_STATIC_ASSERT(sizeof(m_can_regs_t) == 0x200U, m_can_span);

/* CREL: Core Release Register.
 * Version and date of the core, all digits in BCD. Release 0.2.0 of 2009-03-26 reads 0x0209_0326 in this coding.
 * §2.3.2 Table 2 p.7; Table 3 p.7 (example); Table 1 p.5 (reset)
 */
#define M_CAN_CREL_OFFSET 0x000U
#define M_CAN_CREL_RESET UINT32_C(0x00000000)
#define M_CAN_CREL_RESET_MASK UINT32_C(0x00000000)
/* REL: Core release, one BCD digit. Access ro.
 * Contradictions of the manual: crel_field_widths.
 */
#define M_CAN_CREL_REL_Pos 28U
#define M_CAN_CREL_REL_Msk UINT32_C(0xF0000000)
#define M_CAN_CREL_REL_Width 4U
#define M_CAN_CREL_REL_Access "ro"
static inline uint32_t m_can_crel_rel_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CREL_REL_Msk) >> M_CAN_CREL_REL_Pos);
}
/* STEP: Step of the release, one BCD digit. Access ro.
 * Contradictions of the manual: crel_field_widths.
 */
#define M_CAN_CREL_STEP_Pos 24U
#define M_CAN_CREL_STEP_Msk UINT32_C(0x0F000000)
#define M_CAN_CREL_STEP_Width 4U
#define M_CAN_CREL_STEP_Access "ro"
static inline uint32_t m_can_crel_step_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CREL_STEP_Msk) >> M_CAN_CREL_STEP_Pos);
}
/* SUBSTEP: Sub-step of the release, one BCD digit. Access ro.
 * Contradictions of the manual: crel_field_widths.
 */
#define M_CAN_CREL_SUBSTEP_Pos 20U
#define M_CAN_CREL_SUBSTEP_Msk UINT32_C(0x00F00000)
#define M_CAN_CREL_SUBSTEP_Width 4U
#define M_CAN_CREL_SUBSTEP_Access "ro"
static inline uint32_t m_can_crel_substep_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CREL_SUBSTEP_Msk) >> M_CAN_CREL_SUBSTEP_Pos);
}
/* YEAR: Last digit of the year of the time stamp in BCD, fixed at synthesis. Access ro.
 * Contradictions of the manual: crel_field_widths.
 */
#define M_CAN_CREL_YEAR_Pos 16U
#define M_CAN_CREL_YEAR_Msk UINT32_C(0x000F0000)
#define M_CAN_CREL_YEAR_Width 4U
#define M_CAN_CREL_YEAR_Access "ro"
static inline uint32_t m_can_crel_year_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CREL_YEAR_Msk) >> M_CAN_CREL_YEAR_Pos);
}
/* MON: Month of the time stamp, two BCD digits, fixed at synthesis. Access ro. */
#define M_CAN_CREL_MON_Pos 8U
#define M_CAN_CREL_MON_Msk UINT32_C(0x0000FF00)
#define M_CAN_CREL_MON_Width 8U
#define M_CAN_CREL_MON_Access "ro"
static inline uint32_t m_can_crel_mon_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CREL_MON_Msk) >> M_CAN_CREL_MON_Pos);
}
/* DAY: Day of the time stamp, two BCD digits, fixed at synthesis. Access ro. */
#define M_CAN_CREL_DAY_Pos 0U
#define M_CAN_CREL_DAY_Msk UINT32_C(0x000000FF)
#define M_CAN_CREL_DAY_Width 8U
#define M_CAN_CREL_DAY_Access "ro"
static inline uint32_t m_can_crel_day_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CREL_DAY_Msk) >> M_CAN_CREL_DAY_Pos);
}

/* ENDN: Endian Register.
 * Constant for checking the byte order of the bus connection.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.3 Table 4 p.8; Table 1 p.5 (reset)
 */
#define M_CAN_ENDN_OFFSET 0x004U
#define M_CAN_ENDN_RESET UINT32_C(0x87654321)
#define M_CAN_ENDN_RESET_MASK UINT32_C(0xFFFFFFFF)
/* ETV: Endianness test value, always 0x8765_4321. Access ro. */
#define M_CAN_ENDN_ETV_Pos 0U
#define M_CAN_ENDN_ETV_Msk UINT32_C(0xFFFFFFFF)
#define M_CAN_ENDN_ETV_Width 32U
#define M_CAN_ENDN_ETV_Access "ro"
static inline uint32_t m_can_endn_etv_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ENDN_ETV_Msk) >> M_CAN_ENDN_ETV_Pos);
}

/* CUST: Customer Register.
 * Address kept free for one register of the device's maker, which may hold configuration, control and status
 * bits. The device's manual tells whether it exists and what it does.
 * §2.3.1 p.7; Table 1 p.5 (reset and access)
 */
#define M_CAN_CUST_OFFSET 0x008U
#define M_CAN_CUST_RESET UINT32_C(0x00000000)
#define M_CAN_CUST_RESET_MASK UINT32_C(0x00000000)
/* CUST: Meaning, access and reset are defined by the device. Access rw. */
#define M_CAN_CUST_CUST_Pos 0U
#define M_CAN_CUST_CUST_Msk UINT32_C(0xFFFFFFFF)
#define M_CAN_CUST_CUST_Width 32U
#define M_CAN_CUST_CUST_Access "rw"
#define M_CAN_CUST_CUST_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CUST_CUST_Pos) & M_CAN_CUST_CUST_Msk))
static inline uint32_t m_can_cust_cust_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CUST_CUST_Msk) >> M_CAN_CUST_CUST_Pos);
}
static inline uint32_t m_can_cust_cust_set(uint32_t reg, uint32_t value)
{
    return (uint32_t)((reg & (uint32_t)~M_CAN_CUST_CUST_Msk) | M_CAN_CUST_CUST_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_cust_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->CUST;
    regs->CUST = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* DBTP: Data Bit Timing & Prescaler Register.
 * Bit timing of the data phase of CAN FD frames that switch the bit rate. A data bit lasts DTSEG1 + DTSEG2 + 3
 * time quanta (programmed values), 4 to 49. The reset value gives 500 kbit/s with an 8 MHz CAN clock.
 * Hazard: The data bit rate must not be lower than the nominal bit rate.
 * Hazard: With TDC set, only 0 and 1 are valid in DBRP.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.4 Table 5 p.8; Table 1 p.5 (reset and access)
 */
#define M_CAN_DBTP_OFFSET 0x00CU
#define M_CAN_DBTP_RESET UINT32_C(0x00000A33)
#define M_CAN_DBTP_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TDC: Enables the transmitter delay compensation. Access rw:config. A write has an effect only if config
 * (CCCR.INIT && CCCR.CCE).
 * Contradictions of the manual: garbled_letters.
 */
#define M_CAN_DBTP_TDC_Pos 23U
#define M_CAN_DBTP_TDC_Msk UINT32_C(0x00800000)
#define M_CAN_DBTP_TDC_Width 1U
#define M_CAN_DBTP_TDC_Access "rw:config"
#define M_CAN_DBTP_TDC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_DBTP_TDC_Pos) & M_CAN_DBTP_TDC_Msk))
static inline uint32_t m_can_dbtp_tdc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_DBTP_TDC_Msk) >> M_CAN_DBTP_TDC_Pos);
}
static inline uint32_t m_can_dbtp_tdc_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_DBTP_TDC_Msk) | M_CAN_DBTP_TDC_SET(value));
}
/* DBRP: Data bit rate prescaler: the time quantum lasts DBRP + 1 CAN clock periods (mtq). All values are valid
 * while TDC is 0, only 0 and 1 while TDC is 1. Access rw:config. A write has an effect only if config (CCCR.INIT
 * && CCCR.CCE). Means value + 1 mtq.
 */
#define M_CAN_DBTP_DBRP_Pos 16U
#define M_CAN_DBTP_DBRP_Msk UINT32_C(0x001F0000)
#define M_CAN_DBTP_DBRP_Width 5U
#define M_CAN_DBTP_DBRP_Access "rw:config"
#define M_CAN_DBTP_DBRP_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_DBTP_DBRP_Pos) & M_CAN_DBTP_DBRP_Msk))
static inline uint32_t m_can_dbtp_dbrp_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_DBTP_DBRP_Msk) >> M_CAN_DBTP_DBRP_Pos);
}
static inline uint32_t m_can_dbtp_dbrp_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 31U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_DBTP_DBRP_Msk) | M_CAN_DBTP_DBRP_SET(value));
}
/* DTSEG1: Data time segment before the sample point, propagation and phase segment 1 together: DTSEG1 + 1
 * quanta. Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value + 1 tq.
 * §2.3.4 p.9
 */
#define M_CAN_DBTP_DTSEG1_Pos 8U
#define M_CAN_DBTP_DTSEG1_Msk UINT32_C(0x00001F00)
#define M_CAN_DBTP_DTSEG1_Width 5U
#define M_CAN_DBTP_DTSEG1_Access "rw:config"
#define M_CAN_DBTP_DTSEG1_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_DBTP_DTSEG1_Pos) & M_CAN_DBTP_DTSEG1_Msk))
static inline uint32_t m_can_dbtp_dtseg1_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_DBTP_DTSEG1_Msk) >> M_CAN_DBTP_DTSEG1_Pos);
}
static inline uint32_t m_can_dbtp_dtseg1_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 31U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_DBTP_DTSEG1_Msk) | M_CAN_DBTP_DTSEG1_SET(value));
}
/* DTSEG2: Data time segment after the sample point, phase segment 2: DTSEG2 + 1 quanta. 0 is not allowed. Access
 * rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). May be programmed with 1 to 15. Means
 * value + 1 tq.
 * §2.3.4 p.9
 */
#define M_CAN_DBTP_DTSEG2_Pos 4U
#define M_CAN_DBTP_DTSEG2_Msk UINT32_C(0x000000F0)
#define M_CAN_DBTP_DTSEG2_Width 4U
#define M_CAN_DBTP_DTSEG2_Access "rw:config"
#define M_CAN_DBTP_DTSEG2_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_DBTP_DTSEG2_Pos) & M_CAN_DBTP_DTSEG2_Msk))
static inline uint32_t m_can_dbtp_dtseg2_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_DBTP_DTSEG2_Msk) >> M_CAN_DBTP_DTSEG2_Pos);
}
static inline uint32_t m_can_dbtp_dtseg2_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value >= 1U);
    M_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_DBTP_DTSEG2_Msk) | M_CAN_DBTP_DTSEG2_SET(value));
}
/* DSJW: Data resynchronization jump width: DSJW + 1 quanta. Access rw:config. A write has an effect only if
 * config (CCCR.INIT && CCCR.CCE). Means value + 1 tq.
 * §2.3.4 p.9
 */
#define M_CAN_DBTP_DSJW_Pos 0U
#define M_CAN_DBTP_DSJW_Msk UINT32_C(0x0000000F)
#define M_CAN_DBTP_DSJW_Width 4U
#define M_CAN_DBTP_DSJW_Access "rw:config"
#define M_CAN_DBTP_DSJW_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_DBTP_DSJW_Pos) & M_CAN_DBTP_DSJW_Msk))
static inline uint32_t m_can_dbtp_dsjw_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_DBTP_DSJW_Msk) >> M_CAN_DBTP_DSJW_Pos);
}
static inline uint32_t m_can_dbtp_dsjw_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_DBTP_DSJW_Msk) | M_CAN_DBTP_DSJW_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_dbtp_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->DBTP;
    regs->DBTP = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* TEST: Test Register.
 * Test modes and a view of the CAN pins and of the transmit scan. For production and self tests only. Everything
 * returns to its reset value when CCCR.TEST is cleared.
 * Hazard: A value of TX other than core disturbs the message transfer on the bus.
 * Hazard: It takes several Host clock periods until TX reaches the pin m_can_tx and until the level of m_can_rx
 * is seen in RX.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.5 Table 6 p.9; Table 1 p.5 (reset and access); §3.1.9 p.63
 */
#define M_CAN_TEST_OFFSET 0x010U
#define M_CAN_TEST_RESET UINT32_C(0x00000000)
#define M_CAN_TEST_RESET_MASK UINT32_C(0xFFFFFF7F)
/* SVAL: TXBNS is valid. Access ro.
 * Contradictions of the manual: test_monitor_bits.
 */
#define M_CAN_TEST_SVAL_Pos 21U
#define M_CAN_TEST_SVAL_Msk UINT32_C(0x00200000)
#define M_CAN_TEST_SVAL_Width 1U
#define M_CAN_TEST_SVAL_Access "ro"
static inline uint32_t m_can_test_sval_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TEST_SVAL_Msk) >> M_CAN_TEST_SVAL_Pos);
}
/* TXBNS: Number of the Tx Buffer (0 to 31) whose transmission was started last; valid while SVAL is 1. Access
 * ro.
 * Contradictions of the manual: test_monitor_bits.
 */
#define M_CAN_TEST_TXBNS_Pos 16U
#define M_CAN_TEST_TXBNS_Msk UINT32_C(0x001F0000)
#define M_CAN_TEST_TXBNS_Width 5U
#define M_CAN_TEST_TXBNS_Access "ro"
static inline uint32_t m_can_test_txbns_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TEST_TXBNS_Msk) >> M_CAN_TEST_TXBNS_Pos);
}
/* PVAL: TXBNP is valid. Access ro.
 * Contradictions of the manual: test_monitor_bits.
 * §2.3.5 p.9
 */
#define M_CAN_TEST_PVAL_Pos 13U
#define M_CAN_TEST_PVAL_Msk UINT32_C(0x00002000)
#define M_CAN_TEST_PVAL_Width 1U
#define M_CAN_TEST_PVAL_Access "ro"
static inline uint32_t m_can_test_pval_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TEST_PVAL_Msk) >> M_CAN_TEST_PVAL_Pos);
}
/* TXBNP: Number of the Tx Buffer (0 to 31) whose message is prepared for transmission; valid while PVAL is 1.
 * Access ro.
 * Contradictions of the manual: test_monitor_bits.
 */
#define M_CAN_TEST_TXBNP_Pos 8U
#define M_CAN_TEST_TXBNP_Msk UINT32_C(0x00001F00)
#define M_CAN_TEST_TXBNP_Width 5U
#define M_CAN_TEST_TXBNP_Access "ro"
static inline uint32_t m_can_test_txbnp_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TEST_TXBNP_Msk) >> M_CAN_TEST_TXBNP_Pos);
}
/* RX: Level of the pin m_can_rx. Access ro.
 * Contradictions of the manual: test_rx_reset.
 * §2.3.5 p.10
 */
#define M_CAN_TEST_RX_Pos 7U
#define M_CAN_TEST_RX_Msk UINT32_C(0x00000080)
#define M_CAN_TEST_RX_Width 1U
#define M_CAN_TEST_RX_Access "ro"
static inline uint32_t m_can_test_rx_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TEST_RX_Msk) >> M_CAN_TEST_RX_Pos);
}
/* TX: Controls the pin m_can_tx. Access rw:test_access. A write has an effect only if test_access (config &&
 * CCCR.TEST).
 * Contradictions of the manual: test_write_condition.
 * §2.3.5 p.10
 */
#define M_CAN_TEST_TX_Pos 5U
#define M_CAN_TEST_TX_Msk UINT32_C(0x00000060)
#define M_CAN_TEST_TX_Width 2U
#define M_CAN_TEST_TX_Access "rw:test_access"
#define M_CAN_TEST_TX_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TEST_TX_Pos) & M_CAN_TEST_TX_Msk))
static inline uint32_t m_can_test_tx_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TEST_TX_Msk) >> M_CAN_TEST_TX_Pos);
}
static inline uint32_t m_can_test_tx_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TEST_TX_Msk) | M_CAN_TEST_TX_SET(value));
}
/* LBCK: Loop Back Mode: own messages are received and missing acknowledgement is no error. Alone it is external
 * loop back (frames appear at m_can_tx), with CCCR.MON internal loop back (m_can_tx stays recessive). Not to be
 * combined with Restricted Operation Mode. Access rw:test_access. A write has an effect only if test_access
 * (config && CCCR.TEST).
 * Contradictions of the manual: monitoring_and_loop_back, test_write_condition.
 * §2.3.5 p.10; §3.1.9.1 p.63; §3.1.9.2 p.63
 */
#define M_CAN_TEST_LBCK_Pos 4U
#define M_CAN_TEST_LBCK_Msk UINT32_C(0x00000010)
#define M_CAN_TEST_LBCK_Width 1U
#define M_CAN_TEST_LBCK_Access "rw:test_access"
#define M_CAN_TEST_LBCK_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TEST_LBCK_Pos) & M_CAN_TEST_LBCK_Msk))
static inline uint32_t m_can_test_lbck_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TEST_LBCK_Msk) >> M_CAN_TEST_LBCK_Pos);
}
static inline uint32_t m_can_test_lbck_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TEST_LBCK_Msk) | M_CAN_TEST_LBCK_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_test_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->TEST;
    value = (uint32_t)((value & (uint32_t)~UINT32_C(0x003F3F80)) | UINT32_C(0x00000000));
    regs->TEST = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* RWD: RAM Watchdog.
 * Watches the READY answer of the Message RAM. Each access loads the down-counter from WDC; if it reaches zero
 * before READY, it stops and sets IR.WDI. It counts Host clock periods (m_can_hclk).
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.6 Table 7 p.10; Table 1 p.5 (reset and access)
 */
#define M_CAN_RWD_OFFSET 0x014U
#define M_CAN_RWD_RESET UINT32_C(0x00000000)
#define M_CAN_RWD_RESET_MASK UINT32_C(0xFFFFFFFF)
/* WDV: Present value of the watchdog counter. Access ro. Means value m_can_hclk periods.
 * Contradictions of the manual: rwd_bit_numbers.
 */
#define M_CAN_RWD_WDV_Pos 8U
#define M_CAN_RWD_WDV_Msk UINT32_C(0x0000FF00)
#define M_CAN_RWD_WDV_Width 8U
#define M_CAN_RWD_WDV_Access "ro"
static inline uint32_t m_can_rwd_wdv_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RWD_WDV_Msk) >> M_CAN_RWD_WDV_Pos);
}
/* WDC: Start value of the watchdog counter. 0 disables the watchdog. Access rw:config. A write has an effect
 * only if config (CCCR.INIT && CCCR.CCE). Means value m_can_hclk periods.
 * Contradictions of the manual: rwd_bit_numbers, garbled_letters.
 */
#define M_CAN_RWD_WDC_Pos 0U
#define M_CAN_RWD_WDC_Msk UINT32_C(0x000000FF)
#define M_CAN_RWD_WDC_Width 8U
#define M_CAN_RWD_WDC_Access "rw:config"
#define M_CAN_RWD_WDC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RWD_WDC_Pos) & M_CAN_RWD_WDC_Msk))
static inline uint32_t m_can_rwd_wdc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RWD_WDC_Msk) >> M_CAN_RWD_WDC_Pos);
}
static inline uint32_t m_can_rwd_wdc_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 255U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RWD_WDC_Msk) | M_CAN_RWD_WDC_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_rwd_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->RWD;
    value = (uint32_t)((value & (uint32_t)~UINT32_C(0x0000FF00)) | UINT32_C(0x00000000));
    regs->RWD = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* CCCR: CC Control Register.
 * Operating mode. It starts in software initialization (INIT set) and stays off the bus until INIT is cleared.
 * Hazard: Hardware sets INIT on Bus_Off, on an uncorrected Message RAM bit error and for a clock stop. A
 * read-modify-write that read INIT as 0 before such an event clears it again and restarts communication unasked:
 * every write has to carry the intended value of INIT.
 * Hazard: Hardware sets ASM after a Message RAM access failure of the Tx Handler. Writing back an older copy
 * with ASM 0 leaves Restricted Operation Mode unnoticed, because ASM may be cleared at any time.
 * Hazard: CSR also reads 1 while the input m_can_clkstop_req is active. Writing that 1 back turns the pin's
 * request into a software request that outlasts the pin.
 * Hazard: A value written to INIT is visible only after a delay between two clock domains. Read INIT until the
 * last value has been taken over before writing a new one.
 * Hazard: On a heavily disturbed bus a clock stop may never be acknowledged (PSR.ACT does not become idle).
 * Writing INIT 1 then stops communication at once, even within a frame.
 * Hazard: Clearing INIT also clears CCE. Set INIT first, wait until it reads 1, then set CCE in a second write.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.7 Table 8 p.11; Table 1 p.5 (reset and access); §3.1.1 p.57
 */
#define M_CAN_CCCR_OFFSET 0x018U
#define M_CAN_CCCR_RESET UINT32_C(0x00000001)
#define M_CAN_CCCR_RESET_MASK UINT32_C(0xFFFFFFFF)
/* NISO: CAN FD frame format: that of ISO 11898-1:2015 or that of the Bosch CAN FD Specification V1.0. Reserved
 * and read as 0 in devices synthesized for ISO only (iso_only_g). Access rw:config. A write has an effect only
 * if config (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_CCCR_NISO_Pos 15U
#define M_CAN_CCCR_NISO_Msk UINT32_C(0x00008000)
#define M_CAN_CCCR_NISO_Width 1U
#define M_CAN_CCCR_NISO_Access "rw:config"
#define M_CAN_CCCR_NISO_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_NISO_Pos) & M_CAN_CCCR_NISO_Msk))
static inline uint32_t m_can_cccr_niso_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_NISO_Msk) >> M_CAN_CCCR_NISO_Pos);
}
static inline uint32_t m_can_cccr_niso_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_NISO_Msk) | M_CAN_CCCR_NISO_SET(value));
}
/* TXP: Transmit pause: waits two CAN bit times after each own successful transmission before starting the next.
 * Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_CCCR_TXP_Pos 14U
#define M_CAN_CCCR_TXP_Msk UINT32_C(0x00004000)
#define M_CAN_CCCR_TXP_Width 1U
#define M_CAN_CCCR_TXP_Access "rw:config"
#define M_CAN_CCCR_TXP_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_TXP_Pos) & M_CAN_CCCR_TXP_Msk))
static inline uint32_t m_can_cccr_txp_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_TXP_Msk) >> M_CAN_CCCR_TXP_Pos);
}
static inline uint32_t m_can_cccr_txp_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_TXP_Msk) | M_CAN_CCCR_TXP_SET(value));
}
/* EFBI: Edge filtering during bus integration: a hard synchronization edge needs two consecutive dominant
 * quanta. Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_CCCR_EFBI_Pos 13U
#define M_CAN_CCCR_EFBI_Msk UINT32_C(0x00002000)
#define M_CAN_CCCR_EFBI_Width 1U
#define M_CAN_CCCR_EFBI_Access "rw:config"
#define M_CAN_CCCR_EFBI_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_EFBI_Pos) & M_CAN_CCCR_EFBI_Msk))
static inline uint32_t m_can_cccr_efbi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_EFBI_Msk) >> M_CAN_CCCR_EFBI_Pos);
}
static inline uint32_t m_can_cccr_efbi_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_EFBI_Msk) | M_CAN_CCCR_EFBI_SET(value));
}
/* PXHD: Disables protocol exception handling: a recessive res bit after a recessive FDF is then answered with an
 * error frame instead of waiting for the bus to become idle. Access rw:config. A write has an effect only if
 * config (CCCR.INIT && CCCR.CCE).
 * Contradictions of the manual: pxe_with_pxhd.
 */
#define M_CAN_CCCR_PXHD_Pos 12U
#define M_CAN_CCCR_PXHD_Msk UINT32_C(0x00001000)
#define M_CAN_CCCR_PXHD_Width 1U
#define M_CAN_CCCR_PXHD_Access "rw:config"
#define M_CAN_CCCR_PXHD_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_PXHD_Pos) & M_CAN_CCCR_PXHD_Msk))
static inline uint32_t m_can_cccr_pxhd_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_PXHD_Msk) >> M_CAN_CCCR_PXHD_Pos);
}
static inline uint32_t m_can_cccr_pxhd_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_PXHD_Msk) | M_CAN_CCCR_PXHD_SET(value));
}
/* WMM: Width of the Message Markers. UTSU makes them 16 bits wide whatever is set here. Access rw:config. A
 * write has an effect only if config (CCCR.INIT && CCCR.CCE).
 * Contradictions of the manual: wide_marker_timestamps.
 */
#define M_CAN_CCCR_WMM_Pos 11U
#define M_CAN_CCCR_WMM_Msk UINT32_C(0x00000800)
#define M_CAN_CCCR_WMM_Width 1U
#define M_CAN_CCCR_WMM_Access "rw:config"
#define M_CAN_CCCR_WMM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_WMM_Pos) & M_CAN_CCCR_WMM_Msk))
static inline uint32_t m_can_cccr_wmm_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_WMM_Msk) >> M_CAN_CCCR_WMM_Pos);
}
static inline uint32_t m_can_cccr_wmm_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_WMM_Msk) | M_CAN_CCCR_WMM_SET(value));
}
/* UTSU: Use of the Timestamping Unit; also enables wide Message Markers. Fixed to 0 where no TSU is connected
 * (connected_tsu_g = 0). Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_CCCR_UTSU_Pos 10U
#define M_CAN_CCCR_UTSU_Msk UINT32_C(0x00000400)
#define M_CAN_CCCR_UTSU_Width 1U
#define M_CAN_CCCR_UTSU_Access "rw:config"
#define M_CAN_CCCR_UTSU_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_UTSU_Pos) & M_CAN_CCCR_UTSU_Msk))
static inline uint32_t m_can_cccr_utsu_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_UTSU_Msk) >> M_CAN_CCCR_UTSU_Pos);
}
static inline uint32_t m_can_cccr_utsu_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_UTSU_Msk) | M_CAN_CCCR_UTSU_SET(value));
}
/* BRSE: Enables bit rate switching for transmissions. Without effect while FDOE is 0. Access rw:config. A write
 * has an effect only if config (CCCR.INIT && CCCR.CCE).
 * §2.3.7 p.12; §3.1.3 p.58
 */
#define M_CAN_CCCR_BRSE_Pos 9U
#define M_CAN_CCCR_BRSE_Msk UINT32_C(0x00000200)
#define M_CAN_CCCR_BRSE_Width 1U
#define M_CAN_CCCR_BRSE_Access "rw:config"
#define M_CAN_CCCR_BRSE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_BRSE_Pos) & M_CAN_CCCR_BRSE_Msk))
static inline uint32_t m_can_cccr_brse_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_BRSE_Msk) >> M_CAN_CCCR_BRSE_Pos);
}
static inline uint32_t m_can_cccr_brse_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_BRSE_Msk) | M_CAN_CCCR_BRSE_SET(value));
}
/* FDOE: Enables CAN FD. While it is 0, nothing is sent in CAN FD format and received CAN FD frames cause error
 * frames. Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE).
 * §2.3.7 p.12; §3.1.3 p.58
 */
#define M_CAN_CCCR_FDOE_Pos 8U
#define M_CAN_CCCR_FDOE_Msk UINT32_C(0x00000100)
#define M_CAN_CCCR_FDOE_Width 1U
#define M_CAN_CCCR_FDOE_Access "rw:config"
#define M_CAN_CCCR_FDOE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_FDOE_Pos) & M_CAN_CCCR_FDOE_Msk))
static inline uint32_t m_can_cccr_fdoe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_FDOE_Msk) >> M_CAN_CCCR_FDOE_Pos);
}
static inline uint32_t m_can_cccr_fdoe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_FDOE_Msk) | M_CAN_CCCR_FDOE_SET(value));
}
/* TEST: Test mode: opens the register TEST for writing. While it is 0 the register TEST holds its reset values.
 * Access rw+s:config. Can be set only if config (CCCR.INIT && CCCR.CCE), and cleared at any time.
 * §2.3.7 p.12; §3.1.1 p.57
 */
#define M_CAN_CCCR_TEST_Pos 7U
#define M_CAN_CCCR_TEST_Msk UINT32_C(0x00000080)
#define M_CAN_CCCR_TEST_Width 1U
#define M_CAN_CCCR_TEST_Access "rw+s:config"
#define M_CAN_CCCR_TEST_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_TEST_Pos) & M_CAN_CCCR_TEST_Msk))
static inline uint32_t m_can_cccr_test_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_TEST_Msk) >> M_CAN_CCCR_TEST_Pos);
}
static inline uint32_t m_can_cccr_test_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_TEST_Msk) | M_CAN_CCCR_TEST_SET(value));
}
/* DAR: Disables automatic retransmission of messages that lost arbitration or were disturbed. Access rw:config.
 * A write has an effect only if config (CCCR.INIT && CCCR.CCE).
 * Contradictions of the manual: dar_event_type.
 * §2.3.7 p.12; §3.1.1 p.57; §3.1.7 p.62
 */
#define M_CAN_CCCR_DAR_Pos 6U
#define M_CAN_CCCR_DAR_Msk UINT32_C(0x00000040)
#define M_CAN_CCCR_DAR_Width 1U
#define M_CAN_CCCR_DAR_Access "rw:config"
#define M_CAN_CCCR_DAR_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_DAR_Pos) & M_CAN_CCCR_DAR_Msk))
static inline uint32_t m_can_cccr_dar_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_DAR_Msk) >> M_CAN_CCCR_DAR_Pos);
}
static inline uint32_t m_can_cccr_dar_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_DAR_Msk) | M_CAN_CCCR_DAR_SET(value));
}
/* MON: Bus Monitoring Mode: receives, but sends recessive bits only and starts no transmission. Access
 * rw+s:config. Can be set only if config (CCCR.INIT && CCCR.CCE), and cleared at any time.
 * Contradictions of the manual: bus_monitoring_figure, monitoring_and_loop_back.
 * §2.3.7 p.12; §3.1.6 p.61
 */
#define M_CAN_CCCR_MON_Pos 5U
#define M_CAN_CCCR_MON_Msk UINT32_C(0x00000020)
#define M_CAN_CCCR_MON_Width 1U
#define M_CAN_CCCR_MON_Access "rw+s:config"
#define M_CAN_CCCR_MON_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_MON_Pos) & M_CAN_CCCR_MON_Msk))
static inline uint32_t m_can_cccr_mon_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_MON_Msk) >> M_CAN_CCCR_MON_Pos);
}
static inline uint32_t m_can_cccr_mon_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_MON_Msk) | M_CAN_CCCR_MON_SET(value));
}
/* CSR: Clock stop request. Once pending transmissions are done and the bus is idle, INIT and then CSA are set.
 * Also reads 1 while the input m_can_clkstop_req is active. Access rwh. Read and write, but hardware changes it
 * too: writing back a stale value undoes the hardware.
 * §2.3.7 p.12; §3.1.8 p.62
 */
#define M_CAN_CCCR_CSR_Pos 4U
#define M_CAN_CCCR_CSR_Msk UINT32_C(0x00000010)
#define M_CAN_CCCR_CSR_Width 1U
#define M_CAN_CCCR_CSR_Access "rwh"
#define M_CAN_CCCR_CSR_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_CSR_Pos) & M_CAN_CCCR_CSR_Msk))
static inline uint32_t m_can_cccr_csr_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_CSR_Msk) >> M_CAN_CCCR_CSR_Pos);
}
static inline uint32_t m_can_cccr_csr_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_CSR_Msk) | M_CAN_CCCR_CSR_SET(value));
}
/* CSA: Clock stop acknowledged: the Host and CAN clocks may be switched off. Cleared after the request has been
 * withdrawn. Access ro.
 * §2.3.7 p.12; §3.1.8 p.62
 */
#define M_CAN_CCCR_CSA_Pos 3U
#define M_CAN_CCCR_CSA_Msk UINT32_C(0x00000008)
#define M_CAN_CCCR_CSA_Width 1U
#define M_CAN_CCCR_CSA_Access "ro"
static inline uint32_t m_can_cccr_csa_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_CSA_Msk) >> M_CAN_CCCR_CSA_Pos);
}
/* ASM: Restricted Operation Mode: receives and acknowledges, but sends no frames and no dominant error or
 * overload bits; TEC and REC are frozen. Hardware sets it when the Tx Handler cannot read the Message RAM in
 * time, and while the input m_can_cok of a Clock Calibration unit is 0. Access rwh+s:config. Read and write, but
 * hardware changes it too: writing back a stale value undoes the hardware. Can be set only if config (CCCR.INIT
 * && CCCR.CCE), and cleared at any time.
 * §2.3.7 p.12; §3.1.5 p.61
 */
#define M_CAN_CCCR_ASM_Pos 2U
#define M_CAN_CCCR_ASM_Msk UINT32_C(0x00000004)
#define M_CAN_CCCR_ASM_Width 1U
#define M_CAN_CCCR_ASM_Access "rwh+s:config"
#define M_CAN_CCCR_ASM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_ASM_Pos) & M_CAN_CCCR_ASM_Msk))
static inline uint32_t m_can_cccr_asm_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_ASM_Msk) >> M_CAN_CCCR_ASM_Pos);
}
static inline uint32_t m_can_cccr_asm_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_ASM_Msk) | M_CAN_CCCR_ASM_SET(value));
}
/* CCE: Configuration change enable: with INIT set, opens the protected registers for writing. Can be changed
 * only while INIT is 1 and falls with it. Setting it resets the status of FIFOs, Tx Buffers and high priority
 * messages. Access rwh:init. Read and write, but hardware changes it too: writing back a stale value undoes the
 * hardware. A write has an effect only if init (CCCR.INIT). Writing back what was read is harmless: Hardware
 * changes CCE only by clearing it when software itself clears INIT, and a 1 written while INIT is 0 is ignored.
 * Contradictions of the manual: lost_flags_and_cce, dms_reset, cce_edge_or_level, init_and_cce_together.
 * §2.3.7 p.12; §3.1.1 p.57
 */
#define M_CAN_CCCR_CCE_Pos 1U
#define M_CAN_CCCR_CCE_Msk UINT32_C(0x00000002)
#define M_CAN_CCCR_CCE_Width 1U
#define M_CAN_CCCR_CCE_Access "rwh:init"
#define M_CAN_CCCR_CCE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_CCE_Pos) & M_CAN_CCCR_CCE_Msk))
static inline uint32_t m_can_cccr_cce_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_CCE_Msk) >> M_CAN_CCCR_CCE_Pos);
}
static inline uint32_t m_can_cccr_cce_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_CCE_Msk) | M_CAN_CCCR_CCE_SET(value));
}
/* INIT: Software initialization: 1 takes the node off the bus at once and holds m_can_tx recessive, 0 lets it
 * synchronize and take part. Hardware sets it on reset, Bus_Off, an uncorrected Message RAM bit error and clock
 * stop. Access rwh. Read and write, but hardware changes it too: writing back a stale value undoes the hardware.
 * Contradictions of the manual: init_and_cce_together.
 * §2.3.7 p.12; §3.1.1 p.57
 */
#define M_CAN_CCCR_INIT_Pos 0U
#define M_CAN_CCCR_INIT_Msk UINT32_C(0x00000001)
#define M_CAN_CCCR_INIT_Width 1U
#define M_CAN_CCCR_INIT_Access "rwh"
#define M_CAN_CCCR_INIT_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_CCCR_INIT_Pos) & M_CAN_CCCR_INIT_Msk))
static inline uint32_t m_can_cccr_init_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_CCCR_INIT_Msk) >> M_CAN_CCCR_INIT_Pos);
}
static inline uint32_t m_can_cccr_init_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_CCCR_INIT_Msk) | M_CAN_CCCR_INIT_SET(value));
}
/* No read-modify-write: no value written to CSR, ASM, INIT leaves it alone. Compose the whole value and store
 * it.
 */

/* NBTP: Nominal Bit Timing & Prescaler Register.
 * Bit timing of Classical CAN frames and of the arbitration phase of CAN FD frames. A bit lasts NTSEG1 + NTSEG2
 * + 3 time quanta (programmed values). The reset value gives 500 kbit/s with an 8 MHz CAN clock.
 * Contradictions of the manual: bit_tables_missing, nbtp_reset.
 * §2.3.8 Table 9 p.13; Table 1 p.5 (reset and access)
 */
#define M_CAN_NBTP_OFFSET 0x01CU
#define M_CAN_NBTP_RESET UINT32_C(0x06000A03)
#define M_CAN_NBTP_RESET_MASK UINT32_C(0xFFFFFFFF)
/* NSJW: Nominal resynchronization jump width: NSJW + 1 quanta. Access rw:config. A write has an effect only if
 * config (CCCR.INIT && CCCR.CCE). Means value + 1 tq.
 * Contradictions of the manual: revision_history_names.
 */
#define M_CAN_NBTP_NSJW_Pos 25U
#define M_CAN_NBTP_NSJW_Msk UINT32_C(0xFE000000)
#define M_CAN_NBTP_NSJW_Width 7U
#define M_CAN_NBTP_NSJW_Access "rw:config"
#define M_CAN_NBTP_NSJW_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_NBTP_NSJW_Pos) & M_CAN_NBTP_NSJW_Msk))
static inline uint32_t m_can_nbtp_nsjw_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_NBTP_NSJW_Msk) >> M_CAN_NBTP_NSJW_Pos);
}
static inline uint32_t m_can_nbtp_nsjw_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 127U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_NBTP_NSJW_Msk) | M_CAN_NBTP_NSJW_SET(value));
}
/* NBRP: Nominal bit rate prescaler: the time quantum lasts NBRP + 1 CAN clock periods (mtq). Access rw:config. A
 * write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value + 1 mtq.
 */
#define M_CAN_NBTP_NBRP_Pos 16U
#define M_CAN_NBTP_NBRP_Msk UINT32_C(0x01FF0000)
#define M_CAN_NBTP_NBRP_Width 9U
#define M_CAN_NBTP_NBRP_Access "rw:config"
#define M_CAN_NBTP_NBRP_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_NBTP_NBRP_Pos) & M_CAN_NBTP_NBRP_Msk))
static inline uint32_t m_can_nbtp_nbrp_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_NBTP_NBRP_Msk) >> M_CAN_NBTP_NBRP_Pos);
}
static inline uint32_t m_can_nbtp_nbrp_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 511U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_NBTP_NBRP_Msk) | M_CAN_NBTP_NBRP_SET(value));
}
/* NTSEG1: Nominal time segment before the sample point, propagation and phase segment 1 together: NTSEG1 + 1
 * quanta. 0 is not allowed. Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). May
 * be programmed with 1 to 255. Means value + 1 tq.
 * Contradictions of the manual: nominal_bit_time_minimum.
 */
#define M_CAN_NBTP_NTSEG1_Pos 8U
#define M_CAN_NBTP_NTSEG1_Msk UINT32_C(0x0000FF00)
#define M_CAN_NBTP_NTSEG1_Width 8U
#define M_CAN_NBTP_NTSEG1_Access "rw:config"
#define M_CAN_NBTP_NTSEG1_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_NBTP_NTSEG1_Pos) & M_CAN_NBTP_NTSEG1_Msk))
static inline uint32_t m_can_nbtp_ntseg1_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_NBTP_NTSEG1_Msk) >> M_CAN_NBTP_NTSEG1_Pos);
}
static inline uint32_t m_can_nbtp_ntseg1_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value >= 1U);
    M_CAN_ASSERT(value <= 255U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_NBTP_NTSEG1_Msk) | M_CAN_NBTP_NTSEG1_SET(value));
}
/* NTSEG2: Nominal time segment after the sample point, phase segment 2: NTSEG2 + 1 quanta. 0 is not allowed.
 * Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). May be programmed with 1 to
 * 127. Means value + 1 tq.
 * Contradictions of the manual: nominal_bit_time_minimum, revision_history_names.
 */
#define M_CAN_NBTP_NTSEG2_Pos 0U
#define M_CAN_NBTP_NTSEG2_Msk UINT32_C(0x0000007F)
#define M_CAN_NBTP_NTSEG2_Width 7U
#define M_CAN_NBTP_NTSEG2_Access "rw:config"
#define M_CAN_NBTP_NTSEG2_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_NBTP_NTSEG2_Pos) & M_CAN_NBTP_NTSEG2_Msk))
static inline uint32_t m_can_nbtp_ntseg2_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_NBTP_NTSEG2_Msk) >> M_CAN_NBTP_NTSEG2_Pos);
}
static inline uint32_t m_can_nbtp_ntseg2_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value >= 1U);
    M_CAN_ASSERT(value <= 127U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_NBTP_NTSEG2_Msk) | M_CAN_NBTP_NTSEG2_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_nbtp_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->NBTP;
    regs->NBTP = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* TSCC: Timestamp Counter Configuration.
 * Source of the 16-bit timestamp and the prescaler that the timestamp and timeout counters share. Used while
 * CCCR.UTSU is 0.
 * Hazard: CAN FD needs the external counter for its timestamps (TSS = external).
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.9 Table 10 p.14; Table 1 p.5 (reset and access)
 */
#define M_CAN_TSCC_OFFSET 0x020U
#define M_CAN_TSCC_RESET UINT32_C(0x00000000)
#define M_CAN_TSCC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TCP: Prescaler of the timestamp and the timeout counter: they count every TCP + 1 CAN bit times. Access
 * rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value + 1 bit times.
 */
#define M_CAN_TSCC_TCP_Pos 16U
#define M_CAN_TSCC_TCP_Msk UINT32_C(0x000F0000)
#define M_CAN_TSCC_TCP_Width 4U
#define M_CAN_TSCC_TCP_Access "rw:config"
#define M_CAN_TSCC_TCP_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TSCC_TCP_Pos) & M_CAN_TSCC_TCP_Msk))
static inline uint32_t m_can_tscc_tcp_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TSCC_TCP_Msk) >> M_CAN_TSCC_TCP_Pos);
}
static inline uint32_t m_can_tscc_tcp_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TSCC_TCP_Msk) | M_CAN_TSCC_TCP_SET(value));
}
/* TSS: Selects where the timestamp comes from. Access rw:config. A write has an effect only if config (CCCR.INIT
 * && CCCR.CCE).
 */
#define M_CAN_TSCC_TSS_Pos 0U
#define M_CAN_TSCC_TSS_Msk UINT32_C(0x00000003)
#define M_CAN_TSCC_TSS_Width 2U
#define M_CAN_TSCC_TSS_Access "rw:config"
#define M_CAN_TSCC_TSS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TSCC_TSS_Pos) & M_CAN_TSCC_TSS_Msk))
static inline uint32_t m_can_tscc_tss_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TSCC_TSS_Msk) >> M_CAN_TSCC_TSS_Pos);
}
static inline uint32_t m_can_tscc_tss_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TSCC_TSS_Msk) | M_CAN_TSCC_TSS_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_tscc_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->TSCC;
    regs->TSCC = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* TSCV: Timestamp Counter Value.
 * The 16-bit counter that is captured at the start of each received and transmitted frame.
 * Hazard: A write to any one of the four bytes resets the counter, even to a byte that holds no bit of it.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.10 Table 11 p.14; Table 1 p.5 (reset and access)
 */
#define M_CAN_TSCV_OFFSET 0x024U
#define M_CAN_TSCV_RESET UINT32_C(0x00000000)
#define M_CAN_TSCV_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TSC: Timestamp counter. A write resets it to 0 and does not count as a wrap-around. With TSCC.TSS = external
 * it shows the external timebase and a write does nothing. A wrap-around sets IR.TSW. Access
 * wclr:timestamp_resettable. Any write clears or presets it; the written value is ignored. A write has an effect
 * only if timestamp_resettable (TSCC.TSS != external).
 */
#define M_CAN_TSCV_TSC_Pos 0U
#define M_CAN_TSCV_TSC_Msk UINT32_C(0x0000FFFF)
#define M_CAN_TSCV_TSC_Width 16U
#define M_CAN_TSCV_TSC_Access "wclr:timestamp_resettable"
static inline uint32_t m_can_tscv_tsc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TSCV_TSC_Msk) >> M_CAN_TSCV_TSC_Pos);
}
/* Clears or presets the register, as any write does: one store. */
static inline void m_can_tscv_restart(m_can_regs_t *regs)
{
    regs->TSCV = 0U;
}
/* No read-modify-write: no value written to TSC leaves it alone. Compose the whole value and store it. */

/* TOCC: Timeout Counter Configuration.
 * Enable, source and period of the 16-bit timeout down-counter. Its clock prescaler is TSCC.TCP.
 * Hazard: The counter runs on the sample point signal, so with bit rate switching it counts faster in the data
 * phase.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.11 Table 12 p.15; Table 1 p.5 (reset and access); §3.3 p.64
 */
#define M_CAN_TOCC_OFFSET 0x028U
#define M_CAN_TOCC_RESET UINT32_C(0xFFFF0000)
#define M_CAN_TOCC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TOP: Timeout period: start value of the down-counter, in units of TSCC.TCP + 1 CAN bit times. Access
 * rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_TOCC_TOP_Pos 16U
#define M_CAN_TOCC_TOP_Msk UINT32_C(0xFFFF0000)
#define M_CAN_TOCC_TOP_Width 16U
#define M_CAN_TOCC_TOP_Access "rw:config"
#define M_CAN_TOCC_TOP_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TOCC_TOP_Pos) & M_CAN_TOCC_TOP_Msk))
static inline uint32_t m_can_tocc_top_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TOCC_TOP_Msk) >> M_CAN_TOCC_TOP_Pos);
}
static inline uint32_t m_can_tocc_top_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 65535U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TOCC_TOP_Msk) | M_CAN_TOCC_TOP_SET(value));
}
/* TOS: Selects what presets and starts the timeout counter. Access rw:config. A write has an effect only if
 * config (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_TOCC_TOS_Pos 1U
#define M_CAN_TOCC_TOS_Msk UINT32_C(0x00000006)
#define M_CAN_TOCC_TOS_Width 2U
#define M_CAN_TOCC_TOS_Access "rw:config"
#define M_CAN_TOCC_TOS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TOCC_TOS_Pos) & M_CAN_TOCC_TOS_Msk))
static inline uint32_t m_can_tocc_tos_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TOCC_TOS_Msk) >> M_CAN_TOCC_TOS_Pos);
}
static inline uint32_t m_can_tocc_tos_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TOCC_TOS_Msk) | M_CAN_TOCC_TOS_SET(value));
}
/* ETOC: Enables the timeout counter. Access rw:config. A write has an effect only if config (CCCR.INIT &&
 * CCCR.CCE).
 */
#define M_CAN_TOCC_ETOC_Pos 0U
#define M_CAN_TOCC_ETOC_Msk UINT32_C(0x00000001)
#define M_CAN_TOCC_ETOC_Width 1U
#define M_CAN_TOCC_ETOC_Access "rw:config"
#define M_CAN_TOCC_ETOC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TOCC_ETOC_Pos) & M_CAN_TOCC_ETOC_Msk))
static inline uint32_t m_can_tocc_etoc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TOCC_ETOC_Msk) >> M_CAN_TOCC_ETOC_Pos);
}
static inline uint32_t m_can_tocc_etoc_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TOCC_ETOC_Msk) | M_CAN_TOCC_ETOC_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_tocc_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->TOCC;
    regs->TOCC = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* TOCV: Timeout Counter Value.
 * Present value of the timeout counter. It runs only while CCCR.INIT is 0.
 * Hazard: In Continuous Mode a write to any one of the four bytes presets the counter, even to a byte that holds
 * no bit of it.
 * Contradictions of the manual: bit_tables_missing, tocv_bit_table, overview_page_garbled.
 * §2.3.12 Table 13 p.15; Table 1 p.5 (reset and access); §3.3 p.64
 */
#define M_CAN_TOCV_OFFSET 0x02CU
#define M_CAN_TOCV_RESET UINT32_C(0x0000FFFF)
#define M_CAN_TOCV_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TOC: Timeout counter, in units of TSCC.TCP + 1 CAN bit times. At zero it sets IR.TOO; then it restarts at
 * TOCC.TOP in Continuous Mode and stops under FIFO control. In Continuous Mode a write of any value presets it
 * to TOCC.TOP. Access wclr:timeout_continuous. Any write clears or presets it; the written value is ignored. A
 * write has an effect only if timeout_continuous (TOCC.TOS == continuous). A write loads the value of TOCC.TOP.
 * Contradictions of the manual: timeout_at_zero.
 */
#define M_CAN_TOCV_TOC_Pos 0U
#define M_CAN_TOCV_TOC_Msk UINT32_C(0x0000FFFF)
#define M_CAN_TOCV_TOC_Width 16U
#define M_CAN_TOCV_TOC_Access "wclr:timeout_continuous"
static inline uint32_t m_can_tocv_toc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TOCV_TOC_Msk) >> M_CAN_TOCV_TOC_Pos);
}
/* Clears or presets the register, as any write does: one store. */
static inline void m_can_tocv_restart(m_can_regs_t *regs)
{
    regs->TOCV = 0U;
}
/* No read-modify-write: no value written to TOC leaves it alone. Compose the whole value and store it. */

/* ECR: Error Counter Register.
 * Transmit and receive error counters and a count of protocol errors.
 * Hazard: A read that includes byte 2 (bits 23:16) clears CEL. Read TEC and REC with a half-word access to keep
 * it.
 * Contradictions of the manual: bit_tables_missing, overview_page_garbled.
 * §2.3.13 Table 14 p.16; Table 1 p.5 (reset and access)
 */
#define M_CAN_ECR_OFFSET 0x040U
#define M_CAN_ECR_RESET UINT32_C(0x00000000)
#define M_CAN_ECR_RESET_MASK UINT32_C(0xFFFFFFFF)
/* CEL: Error logging counter: counts the protocol errors that increment TEC or REC, and reaching the Bus_Off
 * limit, but not RP being set without a change of REC. It sticks at 0xFF, where a further increment of TEC or
 * REC sets IR.ELO. It counts on in Restricted Operation Mode. Access ro+rc@2. A read of byte 2 of the register
 * clears it.
 */
#define M_CAN_ECR_CEL_Pos 16U
#define M_CAN_ECR_CEL_Msk UINT32_C(0x00FF0000)
#define M_CAN_ECR_CEL_Width 8U
#define M_CAN_ECR_CEL_Access "ro+rc@2"
static inline uint32_t m_can_ecr_cel_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ECR_CEL_Msk) >> M_CAN_ECR_CEL_Pos);
}
/* RP: The receive error count is 128 or more, the error passive level. Access ro. */
#define M_CAN_ECR_RP_Pos 15U
#define M_CAN_ECR_RP_Msk UINT32_C(0x00008000)
#define M_CAN_ECR_RP_Width 1U
#define M_CAN_ECR_RP_Access "ro"
static inline uint32_t m_can_ecr_rp_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ECR_RP_Msk) >> M_CAN_ECR_RP_Pos);
}
/* REC: Receive error counter, 0 to 127. Frozen while CCCR.ASM is 1. Counts the idle sequences during Bus_Off
 * recovery. Access ro.
 * §2.3.13 p.16; §2.3.14 p.19; §3.1.5 p.61
 */
#define M_CAN_ECR_REC_Pos 8U
#define M_CAN_ECR_REC_Msk UINT32_C(0x00007F00)
#define M_CAN_ECR_REC_Width 7U
#define M_CAN_ECR_REC_Access "ro"
static inline uint32_t m_can_ecr_rec_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ECR_REC_Msk) >> M_CAN_ECR_REC_Pos);
}
/* TEC: Transmit error counter, 0 to 255. Frozen while CCCR.ASM is 1. Access ro.
 * §2.3.13 p.16; §3.1.5 p.61
 */
#define M_CAN_ECR_TEC_Pos 0U
#define M_CAN_ECR_TEC_Msk UINT32_C(0x000000FF)
#define M_CAN_ECR_TEC_Width 8U
#define M_CAN_ECR_TEC_Access "ro"
static inline uint32_t m_can_ecr_tec_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ECR_TEC_Msk) >> M_CAN_ECR_TEC_Pos);
}

/* PSR: Protocol Status Register.
 * State of the node, last error codes and what is known about the last received CAN FD message.
 * Hazard: A read that includes byte 0 (bits 7:0) clears PXE, RFDF, RBRS and RESI and sets LEC and DLEC to
 * no_change, although all of these but LEC stand in byte 1. Take one copy per read and evaluate that.
 * Hazard: A byte read of byte 1 shows PXE, RFDF, RBRS, RESI and DLEC without changing them.
 * Contradictions of the manual: bit_tables_missing, overview_page_garbled.
 * §2.3.14 Table 15 p.17; Table 1 p.5 (reset and access)
 */
#define M_CAN_PSR_OFFSET 0x044U
#define M_CAN_PSR_RESET UINT32_C(0x00000707)
#define M_CAN_PSR_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TDCV: Position of the secondary sample point: measured delay from m_can_tx to m_can_rx plus TDCR.TDCO, in CAN
 * clock periods. Updated by each transmitted CAN FD frame while DBTP.TDC is 1, cleared when CCCR.INIT is set.
 * Access ro. Means value mtq.
 * §2.3.14 p.17; §3.1.4.1 p.59
 */
#define M_CAN_PSR_TDCV_Pos 16U
#define M_CAN_PSR_TDCV_Msk UINT32_C(0x007F0000)
#define M_CAN_PSR_TDCV_Width 7U
#define M_CAN_PSR_TDCV_Access "ro"
static inline uint32_t m_can_psr_tdcv_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_PSR_TDCV_Msk) >> M_CAN_PSR_TDCV_Pos);
}
/* PXE: A protocol exception event (recessive FDF and recessive res) happened since byte 0 was last read. Access
 * ro+rc@0. A read of byte 0 of the register clears it.
 * Contradictions of the manual: pxe_with_pxhd.
 * §2.3.14 p.17; §3.1.3 p.58
 */
#define M_CAN_PSR_PXE_Pos 14U
#define M_CAN_PSR_PXE_Msk UINT32_C(0x00004000)
#define M_CAN_PSR_PXE_Width 1U
#define M_CAN_PSR_PXE_Access "ro+rc@0"
static inline uint32_t m_can_psr_pxe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_PSR_PXE_Msk) >> M_CAN_PSR_PXE_Pos);
}
/* RFDF: A CAN FD message was received since byte 0 was last read, whether a filter accepted it or not. Access
 * ro+rc@0. A read of byte 0 of the register clears it.
 */
#define M_CAN_PSR_RFDF_Pos 13U
#define M_CAN_PSR_RFDF_Msk UINT32_C(0x00002000)
#define M_CAN_PSR_RFDF_Width 1U
#define M_CAN_PSR_RFDF_Access "ro+rc@0"
static inline uint32_t m_can_psr_rfdf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_PSR_RFDF_Msk) >> M_CAN_PSR_RFDF_Pos);
}
/* RBRS: BRS bit of the last received CAN FD message; set together with RFDF, independent of filtering. Access
 * ro+rc@0. A read of byte 0 of the register clears it.
 */
#define M_CAN_PSR_RBRS_Pos 12U
#define M_CAN_PSR_RBRS_Msk UINT32_C(0x00001000)
#define M_CAN_PSR_RBRS_Width 1U
#define M_CAN_PSR_RBRS_Access "ro+rc@0"
static inline uint32_t m_can_psr_rbrs_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_PSR_RBRS_Msk) >> M_CAN_PSR_RBRS_Pos);
}
/* RESI: ESI bit of the last received CAN FD message; set together with RFDF, independent of filtering. Access
 * ro+rc@0. A read of byte 0 of the register clears it.
 */
#define M_CAN_PSR_RESI_Pos 11U
#define M_CAN_PSR_RESI_Msk UINT32_C(0x00000800)
#define M_CAN_PSR_RESI_Width 1U
#define M_CAN_PSR_RESI_Access "ro+rc@0"
static inline uint32_t m_can_psr_resi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_PSR_RESI_Msk) >> M_CAN_PSR_RESI_Pos);
}
/* DLEC: Last error in the data phase of a CAN FD frame with bit rate switch. Becomes no_error only when such a
 * frame has been sent or received without error. Access ro+rs@0. A read of byte 0 of the register sets every bit
 * of it.
 */
#define M_CAN_PSR_DLEC_Pos 8U
#define M_CAN_PSR_DLEC_Msk UINT32_C(0x00000700)
#define M_CAN_PSR_DLEC_Width 3U
#define M_CAN_PSR_DLEC_Access "ro+rs@0"
static inline uint32_t m_can_psr_dlec_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_PSR_DLEC_Msk) >> M_CAN_PSR_DLEC_Pos);
}
/* BO: The node is in the Bus_Off state. Access ro.
 * §2.3.14 p.18
 */
#define M_CAN_PSR_BO_Pos 7U
#define M_CAN_PSR_BO_Msk UINT32_C(0x00000080)
#define M_CAN_PSR_BO_Width 1U
#define M_CAN_PSR_BO_Access "ro"
static inline uint32_t m_can_psr_bo_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_PSR_BO_Msk) >> M_CAN_PSR_BO_Pos);
}
/* EW: At least one error counter has reached the warning limit of 96. Access ro.
 * §2.3.14 p.18
 */
#define M_CAN_PSR_EW_Pos 6U
#define M_CAN_PSR_EW_Msk UINT32_C(0x00000040)
#define M_CAN_PSR_EW_Width 1U
#define M_CAN_PSR_EW_Access "ro"
static inline uint32_t m_can_psr_ew_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_PSR_EW_Msk) >> M_CAN_PSR_EW_Pos);
}
/* EP: The node is error passive; while 0 it is error active and sends active error flags. Access ro.
 * §2.3.14 p.18
 */
#define M_CAN_PSR_EP_Pos 5U
#define M_CAN_PSR_EP_Msk UINT32_C(0x00000020)
#define M_CAN_PSR_EP_Width 1U
#define M_CAN_PSR_EP_Access "ro"
static inline uint32_t m_can_psr_ep_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_PSR_EP_Msk) >> M_CAN_PSR_EP_Pos);
}
/* ACT: What the node is doing on the bus. A protocol exception event sets it to synchronizing. Access ro.
 * Contradictions of the manual: synchronizing_or_integrating.
 * §2.3.14 p.18
 */
#define M_CAN_PSR_ACT_Pos 3U
#define M_CAN_PSR_ACT_Msk UINT32_C(0x00000018)
#define M_CAN_PSR_ACT_Width 2U
#define M_CAN_PSR_ACT_Access "ro"
static inline uint32_t m_can_psr_act_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_PSR_ACT_Msk) >> M_CAN_PSR_ACT_Pos);
}
/* LEC: Last error on the bus; no_error after a message was sent or received without error. Once a CAN FD frame
 * with bit rate switch has reached its data phase, the next event is reported in DLEC instead. Access ro+rs@0. A
 * read of byte 0 of the register sets every bit of it.
 * Contradictions of the manual: psr_read_effect, bit0_error_in_recovery.
 * §2.3.14 p.18; §2.3.14 p.19
 */
#define M_CAN_PSR_LEC_Pos 0U
#define M_CAN_PSR_LEC_Msk UINT32_C(0x00000007)
#define M_CAN_PSR_LEC_Width 3U
#define M_CAN_PSR_LEC_Access "ro+rs@0"
static inline uint32_t m_can_psr_lec_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_PSR_LEC_Msk) >> M_CAN_PSR_LEC_Pos);
}

/* TDCR: Transmitter Delay Compensation Register.
 * Secondary sample point offset and measurement window of the transmitter delay compensation.
 * Contradictions of the manual: bit_tables_missing, overview_page_garbled.
 * §2.3.15 Table 16 p.19; Table 1 p.5 (reset and access); §3.1.4 p.59
 */
#define M_CAN_TDCR_OFFSET 0x048U
#define M_CAN_TDCR_RESET UINT32_C(0x00000000)
#define M_CAN_TDCR_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TDCO: Offset of the secondary sample point from the measured delay, in CAN clock periods. Access rw:config. A
 * write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value mtq.
 */
#define M_CAN_TDCR_TDCO_Pos 8U
#define M_CAN_TDCR_TDCO_Msk UINT32_C(0x00007F00)
#define M_CAN_TDCR_TDCO_Width 7U
#define M_CAN_TDCR_TDCO_Access "rw:config"
#define M_CAN_TDCR_TDCO_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TDCR_TDCO_Pos) & M_CAN_TDCR_TDCO_Msk))
static inline uint32_t m_can_tdcr_tdco_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TDCR_TDCO_Msk) >> M_CAN_TDCR_TDCO_Pos);
}
static inline uint32_t m_can_tdcr_tdco_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 127U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TDCR_TDCO_Msk) | M_CAN_TDCR_TDCO_SET(value));
}
/* TDCF: Smallest position of the secondary sample point, in CAN clock periods: dominant edges on m_can_rx that
 * would give an earlier one are ignored. The filter works only if TDCF is greater than TDCO. Access rw:config. A
 * write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value mtq.
 */
#define M_CAN_TDCR_TDCF_Pos 0U
#define M_CAN_TDCR_TDCF_Msk UINT32_C(0x0000007F)
#define M_CAN_TDCR_TDCF_Width 7U
#define M_CAN_TDCR_TDCF_Access "rw:config"
#define M_CAN_TDCR_TDCF_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TDCR_TDCF_Pos) & M_CAN_TDCR_TDCF_Msk))
static inline uint32_t m_can_tdcr_tdcf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TDCR_TDCF_Msk) >> M_CAN_TDCR_TDCF_Pos);
}
static inline uint32_t m_can_tdcr_tdcf_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 127U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TDCR_TDCF_Msk) | M_CAN_TDCR_TDCF_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_tdcr_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->TDCR;
    regs->TDCR = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* IR: Interrupt Register.
 * Interrupt flags. A flag is set by an event, not by a level, whether it is enabled in IE or not, and stays
 * until software writes a 1 to it. A hardware reset clears all.
 * Hazard: Never read-modify-write this register. Write only the flags to be cleared; a written-back copy clears
 * every flag that was set.
 * Hazard: Clearing RF0L, RF1L or TEFL also clears its copy in RXF0S, RXF1S or TXEFS.
 * Contradictions of the manual: bit_tables_missing, overview_page_garbled.
 * §2.3.16 Table 17 p.20; Table 1 p.5 (reset and access)
 */
#define M_CAN_IR_OFFSET 0x050U
#define M_CAN_IR_RESET UINT32_C(0x00000000)
#define M_CAN_IR_RESET_MASK UINT32_C(0xFFFFFFFF)
/* ARA: A reserved address was read or written, also one of an attached DMU or TSU. Reserved bytes inside a
 * register do not count. The output m_can_aei_ara signals such accesses too. Access w1c. A flag: writing 1
 * clears it, writing 0 does nothing.
 * §2.3.16 p.20; §2.2.1 p.6
 */
#define M_CAN_IR_ARA_Pos 29U
#define M_CAN_IR_ARA_Msk UINT32_C(0x20000000)
#define M_CAN_IR_ARA_Width 1U
#define M_CAN_IR_ARA_Access "w1c"
static inline uint32_t m_can_ir_ara_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_ARA_Msk) >> M_CAN_IR_ARA_Pos);
}
/* PED: Protocol error in the data phase: PSR.DLEC took a value other than no_error and no_change. Access w1c. A
 * flag: writing 1 clears it, writing 0 does nothing.
 */
#define M_CAN_IR_PED_Pos 28U
#define M_CAN_IR_PED_Msk UINT32_C(0x10000000)
#define M_CAN_IR_PED_Width 1U
#define M_CAN_IR_PED_Access "w1c"
static inline uint32_t m_can_ir_ped_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_PED_Msk) >> M_CAN_IR_PED_Pos);
}
/* PEA: Protocol error in the arbitration phase: PSR.LEC took a value other than no_error and no_change. Access
 * w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * Contradictions of the manual: bit0_error_in_recovery.
 */
#define M_CAN_IR_PEA_Pos 27U
#define M_CAN_IR_PEA_Msk UINT32_C(0x08000000)
#define M_CAN_IR_PEA_Width 1U
#define M_CAN_IR_PEA_Access "w1c"
static inline uint32_t m_can_ir_pea_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_PEA_Msk) >> M_CAN_IR_PEA_Pos);
}
/* WDI: RAM watchdog: the Message RAM did not answer in time. Access w1c. A flag: writing 1 clears it, writing 0
 * does nothing.
 * §2.3.16 p.20; §2.3.6 p.10
 */
#define M_CAN_IR_WDI_Pos 26U
#define M_CAN_IR_WDI_Msk UINT32_C(0x04000000)
#define M_CAN_IR_WDI_Width 1U
#define M_CAN_IR_WDI_Access "w1c"
static inline uint32_t m_can_ir_wdi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_WDI_Msk) >> M_CAN_IR_WDI_Pos);
}
/* BO: The Bus_Off status changed, in either direction. Access w1c. A flag: writing 1 clears it, writing 0 does
 * nothing.
 */
#define M_CAN_IR_BO_Pos 25U
#define M_CAN_IR_BO_Msk UINT32_C(0x02000000)
#define M_CAN_IR_BO_Width 1U
#define M_CAN_IR_BO_Access "w1c"
static inline uint32_t m_can_ir_bo_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_BO_Msk) >> M_CAN_IR_BO_Pos);
}
/* EW: The error warning status changed, in either direction. Access w1c. A flag: writing 1 clears it, writing 0
 * does nothing.
 */
#define M_CAN_IR_EW_Pos 24U
#define M_CAN_IR_EW_Msk UINT32_C(0x01000000)
#define M_CAN_IR_EW_Width 1U
#define M_CAN_IR_EW_Access "w1c"
static inline uint32_t m_can_ir_ew_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_EW_Msk) >> M_CAN_IR_EW_Pos);
}
/* EP: The error passive status changed, in either direction. Access w1c. A flag: writing 1 clears it, writing 0
 * does nothing.
 */
#define M_CAN_IR_EP_Pos 23U
#define M_CAN_IR_EP_Msk UINT32_C(0x00800000)
#define M_CAN_IR_EP_Width 1U
#define M_CAN_IR_EP_Access "w1c"
static inline uint32_t m_can_ir_ep_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_EP_Msk) >> M_CAN_IR_EP_Pos);
}
/* ELO: TEC or REC was incremented while ECR.CEL stood at 0xFF. Access w1c. A flag: writing 1 clears it, writing
 * 0 does nothing.
 * §2.3.16 p.20; §2.3.13 p.16
 */
#define M_CAN_IR_ELO_Pos 22U
#define M_CAN_IR_ELO_Msk UINT32_C(0x00400000)
#define M_CAN_IR_ELO_Width 1U
#define M_CAN_IR_ELO_Access "w1c"
static inline uint32_t m_can_ir_elo_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_ELO_Msk) >> M_CAN_IR_ELO_Pos);
}
/* BEU: The Message RAM reported a bit error it could not correct (m_can_aeim_berr[1]). The event also sets
 * CCCR.INIT. Access w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * §2.3.16 p.21
 */
#define M_CAN_IR_BEU_Pos 21U
#define M_CAN_IR_BEU_Msk UINT32_C(0x00200000)
#define M_CAN_IR_BEU_Width 1U
#define M_CAN_IR_BEU_Access "w1c"
static inline uint32_t m_can_ir_beu_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_BEU_Msk) >> M_CAN_IR_BEU_Pos);
}
/* BEC: The Message RAM reported a bit error it corrected (m_can_aeim_berr[0]). Access w1c. A flag: writing 1
 * clears it, writing 0 does nothing.
 * §2.3.16 p.21
 */
#define M_CAN_IR_BEC_Pos 20U
#define M_CAN_IR_BEC_Msk UINT32_C(0x00100000)
#define M_CAN_IR_BEC_Width 1U
#define M_CAN_IR_BEC_Access "w1c"
static inline uint32_t m_can_ir_bec_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_BEC_Msk) >> M_CAN_IR_BEC_Pos);
}
/* DRX: A message was stored in a dedicated Rx Buffer; not set for debug messages. Clear it before reading NDAT1
 * and NDAT2. Access w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * Contradictions of the manual: debug_messages_and_drx.
 * §2.3.16 p.21; §3.4.3 p.71; §3.4.4.1 p.72
 */
#define M_CAN_IR_DRX_Pos 19U
#define M_CAN_IR_DRX_Msk UINT32_C(0x00080000)
#define M_CAN_IR_DRX_Width 1U
#define M_CAN_IR_DRX_Access "w1c"
static inline uint32_t m_can_ir_drx_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_DRX_Msk) >> M_CAN_IR_DRX_Pos);
}
/* TOO: The timeout counter reached zero. Access w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * §2.3.16 p.21; §2.3.12 p.15
 */
#define M_CAN_IR_TOO_Pos 18U
#define M_CAN_IR_TOO_Msk UINT32_C(0x00040000)
#define M_CAN_IR_TOO_Width 1U
#define M_CAN_IR_TOO_Access "w1c"
static inline uint32_t m_can_ir_too_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_TOO_Msk) >> M_CAN_IR_TOO_Pos);
}
/* MRAF: Message RAM access failure: filtering or storing a message was not done before the next message's
 * arbitration field, or storing failed (the message is dropped), or the Tx Handler could not read a message in
 * time (the transmission is aborted and CCCR.ASM set). Access w1c. A flag: writing 1 clears it, writing 0 does
 * nothing.
 * §2.3.16 p.21
 */
#define M_CAN_IR_MRAF_Pos 17U
#define M_CAN_IR_MRAF_Msk UINT32_C(0x00020000)
#define M_CAN_IR_MRAF_Width 1U
#define M_CAN_IR_MRAF_Access "w1c"
static inline uint32_t m_can_ir_mraf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_MRAF_Msk) >> M_CAN_IR_MRAF_Pos);
}
/* TSW: The timestamp counter went from non-zero to zero other than by a write to TSCV. Access w1c. A flag:
 * writing 1 clears it, writing 0 does nothing.
 * §2.3.16 p.21; §2.3.10 p.14
 */
#define M_CAN_IR_TSW_Pos 16U
#define M_CAN_IR_TSW_Msk UINT32_C(0x00010000)
#define M_CAN_IR_TSW_Width 1U
#define M_CAN_IR_TSW_Access "w1c"
static inline uint32_t m_can_ir_tsw_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_TSW_Msk) >> M_CAN_IR_TSW_Pos);
}
/* TEFL: A Tx event was lost, because the Tx Event FIFO was full or has size zero. Access w1c. A flag: writing 1
 * clears it, writing 0 does nothing.
 * Contradictions of the manual: lost_event_name.
 * §2.3.16 p.21
 */
#define M_CAN_IR_TEFL_Pos 15U
#define M_CAN_IR_TEFL_Msk UINT32_C(0x00008000)
#define M_CAN_IR_TEFL_Width 1U
#define M_CAN_IR_TEFL_Access "w1c"
static inline uint32_t m_can_ir_tefl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_TEFL_Msk) >> M_CAN_IR_TEFL_Pos);
}
/* TEFF: The Tx Event FIFO became full. Access w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * §2.3.16 p.21
 */
#define M_CAN_IR_TEFF_Pos 14U
#define M_CAN_IR_TEFF_Msk UINT32_C(0x00004000)
#define M_CAN_IR_TEFF_Width 1U
#define M_CAN_IR_TEFF_Access "w1c"
static inline uint32_t m_can_ir_teff_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_TEFF_Msk) >> M_CAN_IR_TEFF_Pos);
}
/* TEFW: The fill level of the Tx Event FIFO reached TXEFC.EFWM. Access w1c. A flag: writing 1 clears it, writing
 * 0 does nothing.
 * §2.3.16 p.21
 */
#define M_CAN_IR_TEFW_Pos 13U
#define M_CAN_IR_TEFW_Msk UINT32_C(0x00002000)
#define M_CAN_IR_TEFW_Width 1U
#define M_CAN_IR_TEFW_Access "w1c"
static inline uint32_t m_can_ir_tefw_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_TEFW_Msk) >> M_CAN_IR_TEFW_Pos);
}
/* TEFN: An element was written to the Tx Event FIFO. Access w1c. A flag: writing 1 clears it, writing 0 does
 * nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_TEFN_Pos 12U
#define M_CAN_IR_TEFN_Msk UINT32_C(0x00001000)
#define M_CAN_IR_TEFN_Width 1U
#define M_CAN_IR_TEFN_Access "w1c"
static inline uint32_t m_can_ir_tefn_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_TEFN_Msk) >> M_CAN_IR_TEFN_Pos);
}
/* TFE: The Tx FIFO became empty. Access w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_TFE_Pos 11U
#define M_CAN_IR_TFE_Msk UINT32_C(0x00000800)
#define M_CAN_IR_TFE_Width 1U
#define M_CAN_IR_TFE_Access "w1c"
static inline uint32_t m_can_ir_tfe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_TFE_Msk) >> M_CAN_IR_TFE_Pos);
}
/* TCF: A transmission cancellation finished. Enabled per Tx Buffer in TXBCIE. Access w1c. A flag: writing 1
 * clears it, writing 0 does nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_TCF_Pos 10U
#define M_CAN_IR_TCF_Msk UINT32_C(0x00000400)
#define M_CAN_IR_TCF_Width 1U
#define M_CAN_IR_TCF_Access "w1c"
static inline uint32_t m_can_ir_tcf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_TCF_Msk) >> M_CAN_IR_TCF_Pos);
}
/* TC: A transmission completed. Enabled per Tx Buffer in TXBTIE. Access w1c. A flag: writing 1 clears it,
 * writing 0 does nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_TC_Pos 9U
#define M_CAN_IR_TC_Msk UINT32_C(0x00000200)
#define M_CAN_IR_TC_Width 1U
#define M_CAN_IR_TC_Access "w1c"
static inline uint32_t m_can_ir_tc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_TC_Msk) >> M_CAN_IR_TC_Pos);
}
/* HPM: A message matched a filter element that sets priority; HPMS tells which. Access w1c. A flag: writing 1
 * clears it, writing 0 does nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_HPM_Pos 8U
#define M_CAN_IR_HPM_Msk UINT32_C(0x00000100)
#define M_CAN_IR_HPM_Width 1U
#define M_CAN_IR_HPM_Access "w1c"
static inline uint32_t m_can_ir_hpm_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_HPM_Msk) >> M_CAN_IR_HPM_Pos);
}
/* RF1L: A message for Rx FIFO 1 was lost, because the FIFO was full in blocking mode or has size zero. Access
 * w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_RF1L_Pos 7U
#define M_CAN_IR_RF1L_Msk UINT32_C(0x00000080)
#define M_CAN_IR_RF1L_Width 1U
#define M_CAN_IR_RF1L_Access "w1c"
static inline uint32_t m_can_ir_rf1l_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_RF1L_Msk) >> M_CAN_IR_RF1L_Pos);
}
/* RF1F: Rx FIFO 1 became full. Access w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_RF1F_Pos 6U
#define M_CAN_IR_RF1F_Msk UINT32_C(0x00000040)
#define M_CAN_IR_RF1F_Width 1U
#define M_CAN_IR_RF1F_Access "w1c"
static inline uint32_t m_can_ir_rf1f_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_RF1F_Msk) >> M_CAN_IR_RF1F_Pos);
}
/* RF1W: The fill level of Rx FIFO 1 reached RXF1C.F1WM. Access w1c. A flag: writing 1 clears it, writing 0 does
 * nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_RF1W_Pos 5U
#define M_CAN_IR_RF1W_Msk UINT32_C(0x00000020)
#define M_CAN_IR_RF1W_Width 1U
#define M_CAN_IR_RF1W_Access "w1c"
static inline uint32_t m_can_ir_rf1w_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_RF1W_Msk) >> M_CAN_IR_RF1W_Pos);
}
/* RF1N: A message was stored in Rx FIFO 1. Access w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * Contradictions of the manual: garbled_letters.
 * §2.3.16 p.22
 */
#define M_CAN_IR_RF1N_Pos 4U
#define M_CAN_IR_RF1N_Msk UINT32_C(0x00000010)
#define M_CAN_IR_RF1N_Width 1U
#define M_CAN_IR_RF1N_Access "w1c"
static inline uint32_t m_can_ir_rf1n_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_RF1N_Msk) >> M_CAN_IR_RF1N_Pos);
}
/* RF0L: A message for Rx FIFO 0 was lost, because the FIFO was full in blocking mode or has size zero. Access
 * w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_RF0L_Pos 3U
#define M_CAN_IR_RF0L_Msk UINT32_C(0x00000008)
#define M_CAN_IR_RF0L_Width 1U
#define M_CAN_IR_RF0L_Access "w1c"
static inline uint32_t m_can_ir_rf0l_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_RF0L_Msk) >> M_CAN_IR_RF0L_Pos);
}
/* RF0F: Rx FIFO 0 became full. Access w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_RF0F_Pos 2U
#define M_CAN_IR_RF0F_Msk UINT32_C(0x00000004)
#define M_CAN_IR_RF0F_Width 1U
#define M_CAN_IR_RF0F_Access "w1c"
static inline uint32_t m_can_ir_rf0f_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_RF0F_Msk) >> M_CAN_IR_RF0F_Pos);
}
/* RF0W: The fill level of Rx FIFO 0 reached RXF0C.F0WM. Access w1c. A flag: writing 1 clears it, writing 0 does
 * nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_RF0W_Pos 1U
#define M_CAN_IR_RF0W_Msk UINT32_C(0x00000002)
#define M_CAN_IR_RF0W_Width 1U
#define M_CAN_IR_RF0W_Access "w1c"
static inline uint32_t m_can_ir_rf0w_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_RF0W_Msk) >> M_CAN_IR_RF0W_Pos);
}
/* RF0N: A message was stored in Rx FIFO 0. Access w1c. A flag: writing 1 clears it, writing 0 does nothing.
 * §2.3.16 p.22
 */
#define M_CAN_IR_RF0N_Pos 0U
#define M_CAN_IR_RF0N_Msk UINT32_C(0x00000001)
#define M_CAN_IR_RF0N_Width 1U
#define M_CAN_IR_RF0N_Access "w1c"
static inline uint32_t m_can_ir_rf0n_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IR_RF0N_Msk) >> M_CAN_IR_RF0N_Pos);
}
/* Clears the given flags and no others: one store, no read. */
static inline void m_can_ir_clear(m_can_regs_t *regs, uint32_t flags)
{
    regs->IR = (uint32_t)(flags & UINT32_C(0x3FFFFFFF));
}

/* IE: Interrupt Enable.
 * Selects the flags of IR that are signalled on an interrupt line. It does not keep a flag from being set.
 * Contradictions of the manual: overview_page_garbled.
 * §2.3.17 Table 18 p.23; Table 1 p.5 (reset and access)
 */
#define M_CAN_IE_OFFSET 0x054U
#define M_CAN_IE_RESET UINT32_C(0x00000000)
#define M_CAN_IE_RESET_MASK UINT32_C(0xFFFFFFFF)
/* ARAE: Signals access to a reserved address (IR.ARA). Access rw. */
#define M_CAN_IE_ARAE_Pos 29U
#define M_CAN_IE_ARAE_Msk UINT32_C(0x20000000)
#define M_CAN_IE_ARAE_Width 1U
#define M_CAN_IE_ARAE_Access "rw"
#define M_CAN_IE_ARAE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_ARAE_Pos) & M_CAN_IE_ARAE_Msk))
static inline uint32_t m_can_ie_arae_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_ARAE_Msk) >> M_CAN_IE_ARAE_Pos);
}
static inline uint32_t m_can_ie_arae_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_ARAE_Msk) | M_CAN_IE_ARAE_SET(value));
}
/* PEDE: Signals a protocol error in the data phase (IR.PED). Access rw. */
#define M_CAN_IE_PEDE_Pos 28U
#define M_CAN_IE_PEDE_Msk UINT32_C(0x10000000)
#define M_CAN_IE_PEDE_Width 1U
#define M_CAN_IE_PEDE_Access "rw"
#define M_CAN_IE_PEDE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_PEDE_Pos) & M_CAN_IE_PEDE_Msk))
static inline uint32_t m_can_ie_pede_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_PEDE_Msk) >> M_CAN_IE_PEDE_Pos);
}
static inline uint32_t m_can_ie_pede_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_PEDE_Msk) | M_CAN_IE_PEDE_SET(value));
}
/* PEAE: Signals a protocol error in the arbitration phase (IR.PEA). Access rw. */
#define M_CAN_IE_PEAE_Pos 27U
#define M_CAN_IE_PEAE_Msk UINT32_C(0x08000000)
#define M_CAN_IE_PEAE_Width 1U
#define M_CAN_IE_PEAE_Access "rw"
#define M_CAN_IE_PEAE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_PEAE_Pos) & M_CAN_IE_PEAE_Msk))
static inline uint32_t m_can_ie_peae_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_PEAE_Msk) >> M_CAN_IE_PEAE_Pos);
}
static inline uint32_t m_can_ie_peae_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_PEAE_Msk) | M_CAN_IE_PEAE_SET(value));
}
/* WDIE: Signals the RAM watchdog (IR.WDI). Access rw. */
#define M_CAN_IE_WDIE_Pos 26U
#define M_CAN_IE_WDIE_Msk UINT32_C(0x04000000)
#define M_CAN_IE_WDIE_Width 1U
#define M_CAN_IE_WDIE_Access "rw"
#define M_CAN_IE_WDIE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_WDIE_Pos) & M_CAN_IE_WDIE_Msk))
static inline uint32_t m_can_ie_wdie_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_WDIE_Msk) >> M_CAN_IE_WDIE_Pos);
}
static inline uint32_t m_can_ie_wdie_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_WDIE_Msk) | M_CAN_IE_WDIE_SET(value));
}
/* BOE: Signals a change of the Bus_Off status (IR.BO). Access rw. */
#define M_CAN_IE_BOE_Pos 25U
#define M_CAN_IE_BOE_Msk UINT32_C(0x02000000)
#define M_CAN_IE_BOE_Width 1U
#define M_CAN_IE_BOE_Access "rw"
#define M_CAN_IE_BOE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_BOE_Pos) & M_CAN_IE_BOE_Msk))
static inline uint32_t m_can_ie_boe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_BOE_Msk) >> M_CAN_IE_BOE_Pos);
}
static inline uint32_t m_can_ie_boe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_BOE_Msk) | M_CAN_IE_BOE_SET(value));
}
/* EWE: Signals a change of the warning status (IR.EW). Access rw. */
#define M_CAN_IE_EWE_Pos 24U
#define M_CAN_IE_EWE_Msk UINT32_C(0x01000000)
#define M_CAN_IE_EWE_Width 1U
#define M_CAN_IE_EWE_Access "rw"
#define M_CAN_IE_EWE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_EWE_Pos) & M_CAN_IE_EWE_Msk))
static inline uint32_t m_can_ie_ewe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_EWE_Msk) >> M_CAN_IE_EWE_Pos);
}
static inline uint32_t m_can_ie_ewe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_EWE_Msk) | M_CAN_IE_EWE_SET(value));
}
/* EPE: Signals a change of the error passive status (IR.EP). Access rw. */
#define M_CAN_IE_EPE_Pos 23U
#define M_CAN_IE_EPE_Msk UINT32_C(0x00800000)
#define M_CAN_IE_EPE_Width 1U
#define M_CAN_IE_EPE_Access "rw"
#define M_CAN_IE_EPE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_EPE_Pos) & M_CAN_IE_EPE_Msk))
static inline uint32_t m_can_ie_epe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_EPE_Msk) >> M_CAN_IE_EPE_Pos);
}
static inline uint32_t m_can_ie_epe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_EPE_Msk) | M_CAN_IE_EPE_SET(value));
}
/* ELOE: Signals an overflow of the error logging counter (IR.ELO). Access rw. */
#define M_CAN_IE_ELOE_Pos 22U
#define M_CAN_IE_ELOE_Msk UINT32_C(0x00400000)
#define M_CAN_IE_ELOE_Width 1U
#define M_CAN_IE_ELOE_Access "rw"
#define M_CAN_IE_ELOE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_ELOE_Pos) & M_CAN_IE_ELOE_Msk))
static inline uint32_t m_can_ie_eloe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_ELOE_Msk) >> M_CAN_IE_ELOE_Pos);
}
static inline uint32_t m_can_ie_eloe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_ELOE_Msk) | M_CAN_IE_ELOE_SET(value));
}
/* BEUE: Signals an uncorrected Message RAM bit error (IR.BEU). Access rw. */
#define M_CAN_IE_BEUE_Pos 21U
#define M_CAN_IE_BEUE_Msk UINT32_C(0x00200000)
#define M_CAN_IE_BEUE_Width 1U
#define M_CAN_IE_BEUE_Access "rw"
#define M_CAN_IE_BEUE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_BEUE_Pos) & M_CAN_IE_BEUE_Msk))
static inline uint32_t m_can_ie_beue_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_BEUE_Msk) >> M_CAN_IE_BEUE_Pos);
}
static inline uint32_t m_can_ie_beue_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_BEUE_Msk) | M_CAN_IE_BEUE_SET(value));
}
/* BECE: Signals a corrected Message RAM bit error (IR.BEC). Access rw. */
#define M_CAN_IE_BECE_Pos 20U
#define M_CAN_IE_BECE_Msk UINT32_C(0x00100000)
#define M_CAN_IE_BECE_Width 1U
#define M_CAN_IE_BECE_Access "rw"
#define M_CAN_IE_BECE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_BECE_Pos) & M_CAN_IE_BECE_Msk))
static inline uint32_t m_can_ie_bece_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_BECE_Msk) >> M_CAN_IE_BECE_Pos);
}
static inline uint32_t m_can_ie_bece_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_BECE_Msk) | M_CAN_IE_BECE_SET(value));
}
/* DRXE: Signals a message stored in a dedicated Rx Buffer (IR.DRX). Access rw. */
#define M_CAN_IE_DRXE_Pos 19U
#define M_CAN_IE_DRXE_Msk UINT32_C(0x00080000)
#define M_CAN_IE_DRXE_Width 1U
#define M_CAN_IE_DRXE_Access "rw"
#define M_CAN_IE_DRXE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_DRXE_Pos) & M_CAN_IE_DRXE_Msk))
static inline uint32_t m_can_ie_drxe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_DRXE_Msk) >> M_CAN_IE_DRXE_Pos);
}
static inline uint32_t m_can_ie_drxe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_DRXE_Msk) | M_CAN_IE_DRXE_SET(value));
}
/* TOOE: Signals a timeout (IR.TOO). Access rw. */
#define M_CAN_IE_TOOE_Pos 18U
#define M_CAN_IE_TOOE_Msk UINT32_C(0x00040000)
#define M_CAN_IE_TOOE_Width 1U
#define M_CAN_IE_TOOE_Access "rw"
#define M_CAN_IE_TOOE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_TOOE_Pos) & M_CAN_IE_TOOE_Msk))
static inline uint32_t m_can_ie_tooe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_TOOE_Msk) >> M_CAN_IE_TOOE_Pos);
}
static inline uint32_t m_can_ie_tooe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_TOOE_Msk) | M_CAN_IE_TOOE_SET(value));
}
/* MRAFE: Signals a Message RAM access failure (IR.MRAF). Access rw. */
#define M_CAN_IE_MRAFE_Pos 17U
#define M_CAN_IE_MRAFE_Msk UINT32_C(0x00020000)
#define M_CAN_IE_MRAFE_Width 1U
#define M_CAN_IE_MRAFE_Access "rw"
#define M_CAN_IE_MRAFE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_MRAFE_Pos) & M_CAN_IE_MRAFE_Msk))
static inline uint32_t m_can_ie_mrafe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_MRAFE_Msk) >> M_CAN_IE_MRAFE_Pos);
}
static inline uint32_t m_can_ie_mrafe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_MRAFE_Msk) | M_CAN_IE_MRAFE_SET(value));
}
/* TSWE: Signals a timestamp wrap-around (IR.TSW). Access rw. */
#define M_CAN_IE_TSWE_Pos 16U
#define M_CAN_IE_TSWE_Msk UINT32_C(0x00010000)
#define M_CAN_IE_TSWE_Width 1U
#define M_CAN_IE_TSWE_Access "rw"
#define M_CAN_IE_TSWE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_TSWE_Pos) & M_CAN_IE_TSWE_Msk))
static inline uint32_t m_can_ie_tswe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_TSWE_Msk) >> M_CAN_IE_TSWE_Pos);
}
static inline uint32_t m_can_ie_tswe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_TSWE_Msk) | M_CAN_IE_TSWE_SET(value));
}
/* TEFLE: Signals a lost Tx event (IR.TEFL). Access rw.
 * Contradictions of the manual: lost_event_name.
 */
#define M_CAN_IE_TEFLE_Pos 15U
#define M_CAN_IE_TEFLE_Msk UINT32_C(0x00008000)
#define M_CAN_IE_TEFLE_Width 1U
#define M_CAN_IE_TEFLE_Access "rw"
#define M_CAN_IE_TEFLE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_TEFLE_Pos) & M_CAN_IE_TEFLE_Msk))
static inline uint32_t m_can_ie_tefle_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_TEFLE_Msk) >> M_CAN_IE_TEFLE_Pos);
}
static inline uint32_t m_can_ie_tefle_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_TEFLE_Msk) | M_CAN_IE_TEFLE_SET(value));
}
/* TEFFE: Signals a full Tx Event FIFO (IR.TEFF). Access rw. */
#define M_CAN_IE_TEFFE_Pos 14U
#define M_CAN_IE_TEFFE_Msk UINT32_C(0x00004000)
#define M_CAN_IE_TEFFE_Width 1U
#define M_CAN_IE_TEFFE_Access "rw"
#define M_CAN_IE_TEFFE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_TEFFE_Pos) & M_CAN_IE_TEFFE_Msk))
static inline uint32_t m_can_ie_teffe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_TEFFE_Msk) >> M_CAN_IE_TEFFE_Pos);
}
static inline uint32_t m_can_ie_teffe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_TEFFE_Msk) | M_CAN_IE_TEFFE_SET(value));
}
/* TEFWE: Signals that the Tx Event FIFO reached its watermark (IR.TEFW). Access rw. */
#define M_CAN_IE_TEFWE_Pos 13U
#define M_CAN_IE_TEFWE_Msk UINT32_C(0x00002000)
#define M_CAN_IE_TEFWE_Width 1U
#define M_CAN_IE_TEFWE_Access "rw"
#define M_CAN_IE_TEFWE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_TEFWE_Pos) & M_CAN_IE_TEFWE_Msk))
static inline uint32_t m_can_ie_tefwe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_TEFWE_Msk) >> M_CAN_IE_TEFWE_Pos);
}
static inline uint32_t m_can_ie_tefwe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_TEFWE_Msk) | M_CAN_IE_TEFWE_SET(value));
}
/* TEFNE: Signals a new Tx Event FIFO entry (IR.TEFN). Access rw. */
#define M_CAN_IE_TEFNE_Pos 12U
#define M_CAN_IE_TEFNE_Msk UINT32_C(0x00001000)
#define M_CAN_IE_TEFNE_Width 1U
#define M_CAN_IE_TEFNE_Access "rw"
#define M_CAN_IE_TEFNE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_TEFNE_Pos) & M_CAN_IE_TEFNE_Msk))
static inline uint32_t m_can_ie_tefne_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_TEFNE_Msk) >> M_CAN_IE_TEFNE_Pos);
}
static inline uint32_t m_can_ie_tefne_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_TEFNE_Msk) | M_CAN_IE_TEFNE_SET(value));
}
/* TFEE: Signals an empty Tx FIFO (IR.TFE). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_TFEE_Pos 11U
#define M_CAN_IE_TFEE_Msk UINT32_C(0x00000800)
#define M_CAN_IE_TFEE_Width 1U
#define M_CAN_IE_TFEE_Access "rw"
#define M_CAN_IE_TFEE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_TFEE_Pos) & M_CAN_IE_TFEE_Msk))
static inline uint32_t m_can_ie_tfee_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_TFEE_Msk) >> M_CAN_IE_TFEE_Pos);
}
static inline uint32_t m_can_ie_tfee_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_TFEE_Msk) | M_CAN_IE_TFEE_SET(value));
}
/* TCFE: Signals a finished cancellation (IR.TCF). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_TCFE_Pos 10U
#define M_CAN_IE_TCFE_Msk UINT32_C(0x00000400)
#define M_CAN_IE_TCFE_Width 1U
#define M_CAN_IE_TCFE_Access "rw"
#define M_CAN_IE_TCFE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_TCFE_Pos) & M_CAN_IE_TCFE_Msk))
static inline uint32_t m_can_ie_tcfe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_TCFE_Msk) >> M_CAN_IE_TCFE_Pos);
}
static inline uint32_t m_can_ie_tcfe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_TCFE_Msk) | M_CAN_IE_TCFE_SET(value));
}
/* TCE: Signals a completed transmission (IR.TC). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_TCE_Pos 9U
#define M_CAN_IE_TCE_Msk UINT32_C(0x00000200)
#define M_CAN_IE_TCE_Width 1U
#define M_CAN_IE_TCE_Access "rw"
#define M_CAN_IE_TCE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_TCE_Pos) & M_CAN_IE_TCE_Msk))
static inline uint32_t m_can_ie_tce_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_TCE_Msk) >> M_CAN_IE_TCE_Pos);
}
static inline uint32_t m_can_ie_tce_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_TCE_Msk) | M_CAN_IE_TCE_SET(value));
}
/* HPME: Signals a high priority message (IR.HPM). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_HPME_Pos 8U
#define M_CAN_IE_HPME_Msk UINT32_C(0x00000100)
#define M_CAN_IE_HPME_Width 1U
#define M_CAN_IE_HPME_Access "rw"
#define M_CAN_IE_HPME_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_HPME_Pos) & M_CAN_IE_HPME_Msk))
static inline uint32_t m_can_ie_hpme_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_HPME_Msk) >> M_CAN_IE_HPME_Pos);
}
static inline uint32_t m_can_ie_hpme_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_HPME_Msk) | M_CAN_IE_HPME_SET(value));
}
/* RF1LE: Signals a lost message of Rx FIFO 1 (IR.RF1L). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_RF1LE_Pos 7U
#define M_CAN_IE_RF1LE_Msk UINT32_C(0x00000080)
#define M_CAN_IE_RF1LE_Width 1U
#define M_CAN_IE_RF1LE_Access "rw"
#define M_CAN_IE_RF1LE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_RF1LE_Pos) & M_CAN_IE_RF1LE_Msk))
static inline uint32_t m_can_ie_rf1le_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_RF1LE_Msk) >> M_CAN_IE_RF1LE_Pos);
}
static inline uint32_t m_can_ie_rf1le_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_RF1LE_Msk) | M_CAN_IE_RF1LE_SET(value));
}
/* RF1FE: Signals a full Rx FIFO 1 (IR.RF1F). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_RF1FE_Pos 6U
#define M_CAN_IE_RF1FE_Msk UINT32_C(0x00000040)
#define M_CAN_IE_RF1FE_Width 1U
#define M_CAN_IE_RF1FE_Access "rw"
#define M_CAN_IE_RF1FE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_RF1FE_Pos) & M_CAN_IE_RF1FE_Msk))
static inline uint32_t m_can_ie_rf1fe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_RF1FE_Msk) >> M_CAN_IE_RF1FE_Pos);
}
static inline uint32_t m_can_ie_rf1fe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_RF1FE_Msk) | M_CAN_IE_RF1FE_SET(value));
}
/* RF1WE: Signals that Rx FIFO 1 reached its watermark (IR.RF1W). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_RF1WE_Pos 5U
#define M_CAN_IE_RF1WE_Msk UINT32_C(0x00000020)
#define M_CAN_IE_RF1WE_Width 1U
#define M_CAN_IE_RF1WE_Access "rw"
#define M_CAN_IE_RF1WE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_RF1WE_Pos) & M_CAN_IE_RF1WE_Msk))
static inline uint32_t m_can_ie_rf1we_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_RF1WE_Msk) >> M_CAN_IE_RF1WE_Pos);
}
static inline uint32_t m_can_ie_rf1we_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_RF1WE_Msk) | M_CAN_IE_RF1WE_SET(value));
}
/* RF1NE: Signals a new message in Rx FIFO 1 (IR.RF1N). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_RF1NE_Pos 4U
#define M_CAN_IE_RF1NE_Msk UINT32_C(0x00000010)
#define M_CAN_IE_RF1NE_Width 1U
#define M_CAN_IE_RF1NE_Access "rw"
#define M_CAN_IE_RF1NE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_RF1NE_Pos) & M_CAN_IE_RF1NE_Msk))
static inline uint32_t m_can_ie_rf1ne_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_RF1NE_Msk) >> M_CAN_IE_RF1NE_Pos);
}
static inline uint32_t m_can_ie_rf1ne_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_RF1NE_Msk) | M_CAN_IE_RF1NE_SET(value));
}
/* RF0LE: Signals a lost message of Rx FIFO 0 (IR.RF0L). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_RF0LE_Pos 3U
#define M_CAN_IE_RF0LE_Msk UINT32_C(0x00000008)
#define M_CAN_IE_RF0LE_Width 1U
#define M_CAN_IE_RF0LE_Access "rw"
#define M_CAN_IE_RF0LE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_RF0LE_Pos) & M_CAN_IE_RF0LE_Msk))
static inline uint32_t m_can_ie_rf0le_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_RF0LE_Msk) >> M_CAN_IE_RF0LE_Pos);
}
static inline uint32_t m_can_ie_rf0le_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_RF0LE_Msk) | M_CAN_IE_RF0LE_SET(value));
}
/* RF0FE: Signals a full Rx FIFO 0 (IR.RF0F). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_RF0FE_Pos 2U
#define M_CAN_IE_RF0FE_Msk UINT32_C(0x00000004)
#define M_CAN_IE_RF0FE_Width 1U
#define M_CAN_IE_RF0FE_Access "rw"
#define M_CAN_IE_RF0FE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_RF0FE_Pos) & M_CAN_IE_RF0FE_Msk))
static inline uint32_t m_can_ie_rf0fe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_RF0FE_Msk) >> M_CAN_IE_RF0FE_Pos);
}
static inline uint32_t m_can_ie_rf0fe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_RF0FE_Msk) | M_CAN_IE_RF0FE_SET(value));
}
/* RF0WE: Signals that Rx FIFO 0 reached its watermark (IR.RF0W). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_RF0WE_Pos 1U
#define M_CAN_IE_RF0WE_Msk UINT32_C(0x00000002)
#define M_CAN_IE_RF0WE_Width 1U
#define M_CAN_IE_RF0WE_Access "rw"
#define M_CAN_IE_RF0WE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_RF0WE_Pos) & M_CAN_IE_RF0WE_Msk))
static inline uint32_t m_can_ie_rf0we_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_RF0WE_Msk) >> M_CAN_IE_RF0WE_Pos);
}
static inline uint32_t m_can_ie_rf0we_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_RF0WE_Msk) | M_CAN_IE_RF0WE_SET(value));
}
/* RF0NE: Signals a new message in Rx FIFO 0 (IR.RF0N). Access rw.
 * §2.3.17 p.24
 */
#define M_CAN_IE_RF0NE_Pos 0U
#define M_CAN_IE_RF0NE_Msk UINT32_C(0x00000001)
#define M_CAN_IE_RF0NE_Width 1U
#define M_CAN_IE_RF0NE_Access "rw"
#define M_CAN_IE_RF0NE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_IE_RF0NE_Pos) & M_CAN_IE_RF0NE_Msk))
static inline uint32_t m_can_ie_rf0ne_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_IE_RF0NE_Msk) >> M_CAN_IE_RF0NE_Pos);
}
static inline uint32_t m_can_ie_rf0ne_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_IE_RF0NE_Msk) | M_CAN_IE_RF0NE_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_ie_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->IE;
    regs->IE = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* ILS: Interrupt Line Select.
 * Assigns each flag of IR to one of the two interrupt lines, which are enabled in ILE. All start on line 0.
 * Contradictions of the manual: overview_page_garbled.
 * §2.3.18 Table 19 p.25; Table 1 p.5 (reset and access)
 */
#define M_CAN_ILS_OFFSET 0x058U
#define M_CAN_ILS_RESET UINT32_C(0x00000000)
#define M_CAN_ILS_RESET_MASK UINT32_C(0xFFFFFFFF)
/* ARAL: Line of IR.ARA (access to reserved address). Access rw.
 * Contradictions of the manual: revision_history_names.
 */
#define M_CAN_ILS_ARAL_Pos 29U
#define M_CAN_ILS_ARAL_Msk UINT32_C(0x20000000)
#define M_CAN_ILS_ARAL_Width 1U
#define M_CAN_ILS_ARAL_Access "rw"
#define M_CAN_ILS_ARAL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_ARAL_Pos) & M_CAN_ILS_ARAL_Msk))
static inline uint32_t m_can_ils_aral_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_ARAL_Msk) >> M_CAN_ILS_ARAL_Pos);
}
static inline uint32_t m_can_ils_aral_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_ARAL_Msk) | M_CAN_ILS_ARAL_SET(value));
}
/* PEDL: Line of IR.PED (protocol error in the data phase). Access rw. */
#define M_CAN_ILS_PEDL_Pos 28U
#define M_CAN_ILS_PEDL_Msk UINT32_C(0x10000000)
#define M_CAN_ILS_PEDL_Width 1U
#define M_CAN_ILS_PEDL_Access "rw"
#define M_CAN_ILS_PEDL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_PEDL_Pos) & M_CAN_ILS_PEDL_Msk))
static inline uint32_t m_can_ils_pedl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_PEDL_Msk) >> M_CAN_ILS_PEDL_Pos);
}
static inline uint32_t m_can_ils_pedl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_PEDL_Msk) | M_CAN_ILS_PEDL_SET(value));
}
/* PEAL: Line of IR.PEA (protocol error in the arbitration phase). Access rw. */
#define M_CAN_ILS_PEAL_Pos 27U
#define M_CAN_ILS_PEAL_Msk UINT32_C(0x08000000)
#define M_CAN_ILS_PEAL_Width 1U
#define M_CAN_ILS_PEAL_Access "rw"
#define M_CAN_ILS_PEAL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_PEAL_Pos) & M_CAN_ILS_PEAL_Msk))
static inline uint32_t m_can_ils_peal_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_PEAL_Msk) >> M_CAN_ILS_PEAL_Pos);
}
static inline uint32_t m_can_ils_peal_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_PEAL_Msk) | M_CAN_ILS_PEAL_SET(value));
}
/* WDIL: Line of IR.WDI (RAM watchdog). Access rw. */
#define M_CAN_ILS_WDIL_Pos 26U
#define M_CAN_ILS_WDIL_Msk UINT32_C(0x04000000)
#define M_CAN_ILS_WDIL_Width 1U
#define M_CAN_ILS_WDIL_Access "rw"
#define M_CAN_ILS_WDIL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_WDIL_Pos) & M_CAN_ILS_WDIL_Msk))
static inline uint32_t m_can_ils_wdil_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_WDIL_Msk) >> M_CAN_ILS_WDIL_Pos);
}
static inline uint32_t m_can_ils_wdil_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_WDIL_Msk) | M_CAN_ILS_WDIL_SET(value));
}
/* BOL: Line of IR.BO (Bus_Off status). Access rw. */
#define M_CAN_ILS_BOL_Pos 25U
#define M_CAN_ILS_BOL_Msk UINT32_C(0x02000000)
#define M_CAN_ILS_BOL_Width 1U
#define M_CAN_ILS_BOL_Access "rw"
#define M_CAN_ILS_BOL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_BOL_Pos) & M_CAN_ILS_BOL_Msk))
static inline uint32_t m_can_ils_bol_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_BOL_Msk) >> M_CAN_ILS_BOL_Pos);
}
static inline uint32_t m_can_ils_bol_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_BOL_Msk) | M_CAN_ILS_BOL_SET(value));
}
/* EWL: Line of IR.EW (warning status). Access rw. */
#define M_CAN_ILS_EWL_Pos 24U
#define M_CAN_ILS_EWL_Msk UINT32_C(0x01000000)
#define M_CAN_ILS_EWL_Width 1U
#define M_CAN_ILS_EWL_Access "rw"
#define M_CAN_ILS_EWL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_EWL_Pos) & M_CAN_ILS_EWL_Msk))
static inline uint32_t m_can_ils_ewl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_EWL_Msk) >> M_CAN_ILS_EWL_Pos);
}
static inline uint32_t m_can_ils_ewl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_EWL_Msk) | M_CAN_ILS_EWL_SET(value));
}
/* EPL: Line of IR.EP (error passive status). Access rw. */
#define M_CAN_ILS_EPL_Pos 23U
#define M_CAN_ILS_EPL_Msk UINT32_C(0x00800000)
#define M_CAN_ILS_EPL_Width 1U
#define M_CAN_ILS_EPL_Access "rw"
#define M_CAN_ILS_EPL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_EPL_Pos) & M_CAN_ILS_EPL_Msk))
static inline uint32_t m_can_ils_epl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_EPL_Msk) >> M_CAN_ILS_EPL_Pos);
}
static inline uint32_t m_can_ils_epl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_EPL_Msk) | M_CAN_ILS_EPL_SET(value));
}
/* ELOL: Line of IR.ELO (error logging overflow). Access rw. */
#define M_CAN_ILS_ELOL_Pos 22U
#define M_CAN_ILS_ELOL_Msk UINT32_C(0x00400000)
#define M_CAN_ILS_ELOL_Width 1U
#define M_CAN_ILS_ELOL_Access "rw"
#define M_CAN_ILS_ELOL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_ELOL_Pos) & M_CAN_ILS_ELOL_Msk))
static inline uint32_t m_can_ils_elol_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_ELOL_Msk) >> M_CAN_ILS_ELOL_Pos);
}
static inline uint32_t m_can_ils_elol_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_ELOL_Msk) | M_CAN_ILS_ELOL_SET(value));
}
/* BEUL: Line of IR.BEU (uncorrected bit error). Access rw. */
#define M_CAN_ILS_BEUL_Pos 21U
#define M_CAN_ILS_BEUL_Msk UINT32_C(0x00200000)
#define M_CAN_ILS_BEUL_Width 1U
#define M_CAN_ILS_BEUL_Access "rw"
#define M_CAN_ILS_BEUL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_BEUL_Pos) & M_CAN_ILS_BEUL_Msk))
static inline uint32_t m_can_ils_beul_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_BEUL_Msk) >> M_CAN_ILS_BEUL_Pos);
}
static inline uint32_t m_can_ils_beul_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_BEUL_Msk) | M_CAN_ILS_BEUL_SET(value));
}
/* BECL: Line of IR.BEC (corrected bit error). Access rw. */
#define M_CAN_ILS_BECL_Pos 20U
#define M_CAN_ILS_BECL_Msk UINT32_C(0x00100000)
#define M_CAN_ILS_BECL_Width 1U
#define M_CAN_ILS_BECL_Access "rw"
#define M_CAN_ILS_BECL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_BECL_Pos) & M_CAN_ILS_BECL_Msk))
static inline uint32_t m_can_ils_becl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_BECL_Msk) >> M_CAN_ILS_BECL_Pos);
}
static inline uint32_t m_can_ils_becl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_BECL_Msk) | M_CAN_ILS_BECL_SET(value));
}
/* DRXL: Line of IR.DRX (message in a dedicated Rx Buffer). Access rw. */
#define M_CAN_ILS_DRXL_Pos 19U
#define M_CAN_ILS_DRXL_Msk UINT32_C(0x00080000)
#define M_CAN_ILS_DRXL_Width 1U
#define M_CAN_ILS_DRXL_Access "rw"
#define M_CAN_ILS_DRXL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_DRXL_Pos) & M_CAN_ILS_DRXL_Msk))
static inline uint32_t m_can_ils_drxl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_DRXL_Msk) >> M_CAN_ILS_DRXL_Pos);
}
static inline uint32_t m_can_ils_drxl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_DRXL_Msk) | M_CAN_ILS_DRXL_SET(value));
}
/* TOOL: Line of IR.TOO (timeout). Access rw. */
#define M_CAN_ILS_TOOL_Pos 18U
#define M_CAN_ILS_TOOL_Msk UINT32_C(0x00040000)
#define M_CAN_ILS_TOOL_Width 1U
#define M_CAN_ILS_TOOL_Access "rw"
#define M_CAN_ILS_TOOL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_TOOL_Pos) & M_CAN_ILS_TOOL_Msk))
static inline uint32_t m_can_ils_tool_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_TOOL_Msk) >> M_CAN_ILS_TOOL_Pos);
}
static inline uint32_t m_can_ils_tool_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_TOOL_Msk) | M_CAN_ILS_TOOL_SET(value));
}
/* MRAFL: Line of IR.MRAF (Message RAM access failure). Access rw. */
#define M_CAN_ILS_MRAFL_Pos 17U
#define M_CAN_ILS_MRAFL_Msk UINT32_C(0x00020000)
#define M_CAN_ILS_MRAFL_Width 1U
#define M_CAN_ILS_MRAFL_Access "rw"
#define M_CAN_ILS_MRAFL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_MRAFL_Pos) & M_CAN_ILS_MRAFL_Msk))
static inline uint32_t m_can_ils_mrafl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_MRAFL_Msk) >> M_CAN_ILS_MRAFL_Pos);
}
static inline uint32_t m_can_ils_mrafl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_MRAFL_Msk) | M_CAN_ILS_MRAFL_SET(value));
}
/* TSWL: Line of IR.TSW (timestamp wrap-around). Access rw. */
#define M_CAN_ILS_TSWL_Pos 16U
#define M_CAN_ILS_TSWL_Msk UINT32_C(0x00010000)
#define M_CAN_ILS_TSWL_Width 1U
#define M_CAN_ILS_TSWL_Access "rw"
#define M_CAN_ILS_TSWL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_TSWL_Pos) & M_CAN_ILS_TSWL_Msk))
static inline uint32_t m_can_ils_tswl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_TSWL_Msk) >> M_CAN_ILS_TSWL_Pos);
}
static inline uint32_t m_can_ils_tswl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_TSWL_Msk) | M_CAN_ILS_TSWL_SET(value));
}
/* TEFLL: Line of IR.TEFL (Tx event lost). Access rw.
 * Contradictions of the manual: lost_event_name.
 */
#define M_CAN_ILS_TEFLL_Pos 15U
#define M_CAN_ILS_TEFLL_Msk UINT32_C(0x00008000)
#define M_CAN_ILS_TEFLL_Width 1U
#define M_CAN_ILS_TEFLL_Access "rw"
#define M_CAN_ILS_TEFLL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_TEFLL_Pos) & M_CAN_ILS_TEFLL_Msk))
static inline uint32_t m_can_ils_tefll_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_TEFLL_Msk) >> M_CAN_ILS_TEFLL_Pos);
}
static inline uint32_t m_can_ils_tefll_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_TEFLL_Msk) | M_CAN_ILS_TEFLL_SET(value));
}
/* TEFFL: Line of IR.TEFF (Tx Event FIFO full). Access rw. */
#define M_CAN_ILS_TEFFL_Pos 14U
#define M_CAN_ILS_TEFFL_Msk UINT32_C(0x00004000)
#define M_CAN_ILS_TEFFL_Width 1U
#define M_CAN_ILS_TEFFL_Access "rw"
#define M_CAN_ILS_TEFFL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_TEFFL_Pos) & M_CAN_ILS_TEFFL_Msk))
static inline uint32_t m_can_ils_teffl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_TEFFL_Msk) >> M_CAN_ILS_TEFFL_Pos);
}
static inline uint32_t m_can_ils_teffl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_TEFFL_Msk) | M_CAN_ILS_TEFFL_SET(value));
}
/* TEFWL: Line of IR.TEFW (Tx Event FIFO watermark). Access rw. */
#define M_CAN_ILS_TEFWL_Pos 13U
#define M_CAN_ILS_TEFWL_Msk UINT32_C(0x00002000)
#define M_CAN_ILS_TEFWL_Width 1U
#define M_CAN_ILS_TEFWL_Access "rw"
#define M_CAN_ILS_TEFWL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_TEFWL_Pos) & M_CAN_ILS_TEFWL_Msk))
static inline uint32_t m_can_ils_tefwl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_TEFWL_Msk) >> M_CAN_ILS_TEFWL_Pos);
}
static inline uint32_t m_can_ils_tefwl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_TEFWL_Msk) | M_CAN_ILS_TEFWL_SET(value));
}
/* TEFNL: Line of IR.TEFN (new Tx Event FIFO entry). Access rw.
 * Contradictions of the manual: tefnl_name.
 */
#define M_CAN_ILS_TEFNL_Pos 12U
#define M_CAN_ILS_TEFNL_Msk UINT32_C(0x00001000)
#define M_CAN_ILS_TEFNL_Width 1U
#define M_CAN_ILS_TEFNL_Access "rw"
#define M_CAN_ILS_TEFNL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_TEFNL_Pos) & M_CAN_ILS_TEFNL_Msk))
static inline uint32_t m_can_ils_tefnl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_TEFNL_Msk) >> M_CAN_ILS_TEFNL_Pos);
}
static inline uint32_t m_can_ils_tefnl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_TEFNL_Msk) | M_CAN_ILS_TEFNL_SET(value));
}
/* TFEL: Line of IR.TFE (Tx FIFO empty). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_TFEL_Pos 11U
#define M_CAN_ILS_TFEL_Msk UINT32_C(0x00000800)
#define M_CAN_ILS_TFEL_Width 1U
#define M_CAN_ILS_TFEL_Access "rw"
#define M_CAN_ILS_TFEL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_TFEL_Pos) & M_CAN_ILS_TFEL_Msk))
static inline uint32_t m_can_ils_tfel_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_TFEL_Msk) >> M_CAN_ILS_TFEL_Pos);
}
static inline uint32_t m_can_ils_tfel_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_TFEL_Msk) | M_CAN_ILS_TFEL_SET(value));
}
/* TCFL: Line of IR.TCF (cancellation finished). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_TCFL_Pos 10U
#define M_CAN_ILS_TCFL_Msk UINT32_C(0x00000400)
#define M_CAN_ILS_TCFL_Width 1U
#define M_CAN_ILS_TCFL_Access "rw"
#define M_CAN_ILS_TCFL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_TCFL_Pos) & M_CAN_ILS_TCFL_Msk))
static inline uint32_t m_can_ils_tcfl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_TCFL_Msk) >> M_CAN_ILS_TCFL_Pos);
}
static inline uint32_t m_can_ils_tcfl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_TCFL_Msk) | M_CAN_ILS_TCFL_SET(value));
}
/* TCL: Line of IR.TC (transmission completed). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_TCL_Pos 9U
#define M_CAN_ILS_TCL_Msk UINT32_C(0x00000200)
#define M_CAN_ILS_TCL_Width 1U
#define M_CAN_ILS_TCL_Access "rw"
#define M_CAN_ILS_TCL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_TCL_Pos) & M_CAN_ILS_TCL_Msk))
static inline uint32_t m_can_ils_tcl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_TCL_Msk) >> M_CAN_ILS_TCL_Pos);
}
static inline uint32_t m_can_ils_tcl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_TCL_Msk) | M_CAN_ILS_TCL_SET(value));
}
/* HPML: Line of IR.HPM (high priority message). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_HPML_Pos 8U
#define M_CAN_ILS_HPML_Msk UINT32_C(0x00000100)
#define M_CAN_ILS_HPML_Width 1U
#define M_CAN_ILS_HPML_Access "rw"
#define M_CAN_ILS_HPML_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_HPML_Pos) & M_CAN_ILS_HPML_Msk))
static inline uint32_t m_can_ils_hpml_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_HPML_Msk) >> M_CAN_ILS_HPML_Pos);
}
static inline uint32_t m_can_ils_hpml_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_HPML_Msk) | M_CAN_ILS_HPML_SET(value));
}
/* RF1LL: Line of IR.RF1L (Rx FIFO 1 message lost). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_RF1LL_Pos 7U
#define M_CAN_ILS_RF1LL_Msk UINT32_C(0x00000080)
#define M_CAN_ILS_RF1LL_Width 1U
#define M_CAN_ILS_RF1LL_Access "rw"
#define M_CAN_ILS_RF1LL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_RF1LL_Pos) & M_CAN_ILS_RF1LL_Msk))
static inline uint32_t m_can_ils_rf1ll_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_RF1LL_Msk) >> M_CAN_ILS_RF1LL_Pos);
}
static inline uint32_t m_can_ils_rf1ll_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_RF1LL_Msk) | M_CAN_ILS_RF1LL_SET(value));
}
/* RF1FL: Line of IR.RF1F (Rx FIFO 1 full). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_RF1FL_Pos 6U
#define M_CAN_ILS_RF1FL_Msk UINT32_C(0x00000040)
#define M_CAN_ILS_RF1FL_Width 1U
#define M_CAN_ILS_RF1FL_Access "rw"
#define M_CAN_ILS_RF1FL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_RF1FL_Pos) & M_CAN_ILS_RF1FL_Msk))
static inline uint32_t m_can_ils_rf1fl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_RF1FL_Msk) >> M_CAN_ILS_RF1FL_Pos);
}
static inline uint32_t m_can_ils_rf1fl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_RF1FL_Msk) | M_CAN_ILS_RF1FL_SET(value));
}
/* RF1WL: Line of IR.RF1W (Rx FIFO 1 watermark). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_RF1WL_Pos 5U
#define M_CAN_ILS_RF1WL_Msk UINT32_C(0x00000020)
#define M_CAN_ILS_RF1WL_Width 1U
#define M_CAN_ILS_RF1WL_Access "rw"
#define M_CAN_ILS_RF1WL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_RF1WL_Pos) & M_CAN_ILS_RF1WL_Msk))
static inline uint32_t m_can_ils_rf1wl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_RF1WL_Msk) >> M_CAN_ILS_RF1WL_Pos);
}
static inline uint32_t m_can_ils_rf1wl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_RF1WL_Msk) | M_CAN_ILS_RF1WL_SET(value));
}
/* RF1NL: Line of IR.RF1N (new message in Rx FIFO 1). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_RF1NL_Pos 4U
#define M_CAN_ILS_RF1NL_Msk UINT32_C(0x00000010)
#define M_CAN_ILS_RF1NL_Width 1U
#define M_CAN_ILS_RF1NL_Access "rw"
#define M_CAN_ILS_RF1NL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_RF1NL_Pos) & M_CAN_ILS_RF1NL_Msk))
static inline uint32_t m_can_ils_rf1nl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_RF1NL_Msk) >> M_CAN_ILS_RF1NL_Pos);
}
static inline uint32_t m_can_ils_rf1nl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_RF1NL_Msk) | M_CAN_ILS_RF1NL_SET(value));
}
/* RF0LL: Line of IR.RF0L (Rx FIFO 0 message lost). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_RF0LL_Pos 3U
#define M_CAN_ILS_RF0LL_Msk UINT32_C(0x00000008)
#define M_CAN_ILS_RF0LL_Width 1U
#define M_CAN_ILS_RF0LL_Access "rw"
#define M_CAN_ILS_RF0LL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_RF0LL_Pos) & M_CAN_ILS_RF0LL_Msk))
static inline uint32_t m_can_ils_rf0ll_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_RF0LL_Msk) >> M_CAN_ILS_RF0LL_Pos);
}
static inline uint32_t m_can_ils_rf0ll_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_RF0LL_Msk) | M_CAN_ILS_RF0LL_SET(value));
}
/* RF0FL: Line of IR.RF0F (Rx FIFO 0 full). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_RF0FL_Pos 2U
#define M_CAN_ILS_RF0FL_Msk UINT32_C(0x00000004)
#define M_CAN_ILS_RF0FL_Width 1U
#define M_CAN_ILS_RF0FL_Access "rw"
#define M_CAN_ILS_RF0FL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_RF0FL_Pos) & M_CAN_ILS_RF0FL_Msk))
static inline uint32_t m_can_ils_rf0fl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_RF0FL_Msk) >> M_CAN_ILS_RF0FL_Pos);
}
static inline uint32_t m_can_ils_rf0fl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_RF0FL_Msk) | M_CAN_ILS_RF0FL_SET(value));
}
/* RF0WL: Line of IR.RF0W (Rx FIFO 0 watermark). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_RF0WL_Pos 1U
#define M_CAN_ILS_RF0WL_Msk UINT32_C(0x00000002)
#define M_CAN_ILS_RF0WL_Width 1U
#define M_CAN_ILS_RF0WL_Access "rw"
#define M_CAN_ILS_RF0WL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_RF0WL_Pos) & M_CAN_ILS_RF0WL_Msk))
static inline uint32_t m_can_ils_rf0wl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_RF0WL_Msk) >> M_CAN_ILS_RF0WL_Pos);
}
static inline uint32_t m_can_ils_rf0wl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_RF0WL_Msk) | M_CAN_ILS_RF0WL_SET(value));
}
/* RF0NL: Line of IR.RF0N (new message in Rx FIFO 0). Access rw.
 * §2.3.18 p.26
 */
#define M_CAN_ILS_RF0NL_Pos 0U
#define M_CAN_ILS_RF0NL_Msk UINT32_C(0x00000001)
#define M_CAN_ILS_RF0NL_Width 1U
#define M_CAN_ILS_RF0NL_Access "rw"
#define M_CAN_ILS_RF0NL_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILS_RF0NL_Pos) & M_CAN_ILS_RF0NL_Msk))
static inline uint32_t m_can_ils_rf0nl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILS_RF0NL_Msk) >> M_CAN_ILS_RF0NL_Pos);
}
static inline uint32_t m_can_ils_rf0nl_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILS_RF0NL_Msk) | M_CAN_ILS_RF0NL_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_ils_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->ILS;
    regs->ILS = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* ILE: Interrupt Line Enable.
 * Enables the two interrupt lines. Both are off after reset.
 * Contradictions of the manual: bit_tables_missing, ile_table_title, overview_page_garbled.
 * §2.3.19 Table 20 p.26; Table 1 p.5 (reset and access)
 */
#define M_CAN_ILE_OFFSET 0x05CU
#define M_CAN_ILE_RESET UINT32_C(0x00000000)
#define M_CAN_ILE_RESET_MASK UINT32_C(0xFFFFFFFF)
/* EINT1: Enables interrupt line m_can_int1. Access rw. */
#define M_CAN_ILE_EINT1_Pos 1U
#define M_CAN_ILE_EINT1_Msk UINT32_C(0x00000002)
#define M_CAN_ILE_EINT1_Width 1U
#define M_CAN_ILE_EINT1_Access "rw"
#define M_CAN_ILE_EINT1_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILE_EINT1_Pos) & M_CAN_ILE_EINT1_Msk))
static inline uint32_t m_can_ile_eint1_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILE_EINT1_Msk) >> M_CAN_ILE_EINT1_Pos);
}
static inline uint32_t m_can_ile_eint1_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILE_EINT1_Msk) | M_CAN_ILE_EINT1_SET(value));
}
/* EINT0: Enables interrupt line m_can_int0. Access rw. */
#define M_CAN_ILE_EINT0_Pos 0U
#define M_CAN_ILE_EINT0_Msk UINT32_C(0x00000001)
#define M_CAN_ILE_EINT0_Width 1U
#define M_CAN_ILE_EINT0_Access "rw"
#define M_CAN_ILE_EINT0_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_ILE_EINT0_Pos) & M_CAN_ILE_EINT0_Msk))
static inline uint32_t m_can_ile_eint0_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_ILE_EINT0_Msk) >> M_CAN_ILE_EINT0_Pos);
}
static inline uint32_t m_can_ile_eint0_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_ILE_EINT0_Msk) | M_CAN_ILE_EINT0_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_ile_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->ILE;
    regs->ILE = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* GFC: Global Filter Configuration.
 * What happens to remote frames and to frames that match no filter element. The reset value takes every
 * non-matching frame into Rx FIFO 0 and rejects no remote frames.
 * Contradictions of the manual: bit_tables_missing, overview_page_garbled.
 * §2.3.20 Table 21 p.27; Table 1 p.5 (reset and access)
 */
#define M_CAN_GFC_OFFSET 0x080U
#define M_CAN_GFC_RESET UINT32_C(0x00000000)
#define M_CAN_GFC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* ANFS: Non-matching frames with 11-bit identifiers. Access rw:config. A write has an effect only if config
 * (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_GFC_ANFS_Pos 4U
#define M_CAN_GFC_ANFS_Msk UINT32_C(0x00000030)
#define M_CAN_GFC_ANFS_Width 2U
#define M_CAN_GFC_ANFS_Access "rw:config"
#define M_CAN_GFC_ANFS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_GFC_ANFS_Pos) & M_CAN_GFC_ANFS_Msk))
static inline uint32_t m_can_gfc_anfs_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_GFC_ANFS_Msk) >> M_CAN_GFC_ANFS_Pos);
}
static inline uint32_t m_can_gfc_anfs_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_GFC_ANFS_Msk) | M_CAN_GFC_ANFS_SET(value));
}
/* ANFE: Non-matching frames with 29-bit identifiers. Access rw:config. A write has an effect only if config
 * (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_GFC_ANFE_Pos 2U
#define M_CAN_GFC_ANFE_Msk UINT32_C(0x0000000C)
#define M_CAN_GFC_ANFE_Width 2U
#define M_CAN_GFC_ANFE_Access "rw:config"
#define M_CAN_GFC_ANFE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_GFC_ANFE_Pos) & M_CAN_GFC_ANFE_Msk))
static inline uint32_t m_can_gfc_anfe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_GFC_ANFE_Msk) >> M_CAN_GFC_ANFE_Pos);
}
static inline uint32_t m_can_gfc_anfe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_GFC_ANFE_Msk) | M_CAN_GFC_ANFE_SET(value));
}
/* RRFS: Remote frames with 11-bit identifiers. Access rw:config. A write has an effect only if config (CCCR.INIT
 * && CCCR.CCE).
 */
#define M_CAN_GFC_RRFS_Pos 1U
#define M_CAN_GFC_RRFS_Msk UINT32_C(0x00000002)
#define M_CAN_GFC_RRFS_Width 1U
#define M_CAN_GFC_RRFS_Access "rw:config"
#define M_CAN_GFC_RRFS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_GFC_RRFS_Pos) & M_CAN_GFC_RRFS_Msk))
static inline uint32_t m_can_gfc_rrfs_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_GFC_RRFS_Msk) >> M_CAN_GFC_RRFS_Pos);
}
static inline uint32_t m_can_gfc_rrfs_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_GFC_RRFS_Msk) | M_CAN_GFC_RRFS_SET(value));
}
/* RRFE: Remote frames with 29-bit identifiers. Access rw:config. A write has an effect only if config (CCCR.INIT
 * && CCCR.CCE).
 */
#define M_CAN_GFC_RRFE_Pos 0U
#define M_CAN_GFC_RRFE_Msk UINT32_C(0x00000001)
#define M_CAN_GFC_RRFE_Width 1U
#define M_CAN_GFC_RRFE_Access "rw:config"
#define M_CAN_GFC_RRFE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_GFC_RRFE_Pos) & M_CAN_GFC_RRFE_Msk))
static inline uint32_t m_can_gfc_rrfe_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_GFC_RRFE_Msk) >> M_CAN_GFC_RRFE_Pos);
}
static inline uint32_t m_can_gfc_rrfe_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_GFC_RRFE_Msk) | M_CAN_GFC_RRFE_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_gfc_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->GFC;
    regs->GFC = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* SIDFC: Standard ID Filter Configuration.
 * Place and length of the filter list for 11-bit identifiers.
 * A write is dangerous: The Rx Handler reads its filter list from the Message RAM at this unchecked address and
 * length.
 * Contradictions of the manual: bit_tables_missing, overview_page_garbled.
 * §2.3.21 Table 22 p.28; Table 1 p.5 (reset and access); §2.4.1 p.46
 */
#define M_CAN_SIDFC_OFFSET 0x084U
#define M_CAN_SIDFC_RESET UINT32_C(0x00000000)
#define M_CAN_SIDFC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* LSS: Number of standard filter elements: 0 for no filter list, 1 to 128; more than 128 counts as 128. Access
 * rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value elements.
 * Contradictions of the manual: number_of_filters.
 */
#define M_CAN_SIDFC_LSS_Pos 16U
#define M_CAN_SIDFC_LSS_Msk UINT32_C(0x00FF0000)
#define M_CAN_SIDFC_LSS_Width 8U
#define M_CAN_SIDFC_LSS_Access "rw:config"
#define M_CAN_SIDFC_LSS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_SIDFC_LSS_Pos) & M_CAN_SIDFC_LSS_Msk))
static inline uint32_t m_can_sidfc_lss_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_SIDFC_LSS_Msk) >> M_CAN_SIDFC_LSS_Pos);
}
static inline uint32_t m_can_sidfc_lss_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 255U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_SIDFC_LSS_Msk) | M_CAN_SIDFC_LSS_SET(value));
}
/* FLSSA: Start of the standard filter list in Message RAM, as a 32-bit word address. Access rw:config. A write
 * has an effect only if config (CCCR.INIT && CCCR.CCE). Means value words.
 */
#define M_CAN_SIDFC_FLSSA_Pos 2U
#define M_CAN_SIDFC_FLSSA_Msk UINT32_C(0x0000FFFC)
#define M_CAN_SIDFC_FLSSA_Width 14U
#define M_CAN_SIDFC_FLSSA_Access "rw:config"
#define M_CAN_SIDFC_FLSSA_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_SIDFC_FLSSA_Pos) & M_CAN_SIDFC_FLSSA_Msk))
static inline uint32_t m_can_sidfc_flssa_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_SIDFC_FLSSA_Msk) >> M_CAN_SIDFC_FLSSA_Pos);
}
static inline uint32_t m_can_sidfc_flssa_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 16383U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_SIDFC_FLSSA_Msk) | M_CAN_SIDFC_FLSSA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_sidfc_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->SIDFC;
    regs->SIDFC = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* XIDFC: Extended ID Filter Configuration.
 * Place and length of the filter list for 29-bit identifiers.
 * A write is dangerous: The Rx Handler reads its filter list from the Message RAM at this unchecked address and
 * length.
 * Contradictions of the manual: bit_tables_missing, xidfc_path, overview_page_garbled.
 * §2.3.22 Table 23 p.28; Table 1 p.6 (reset and access); §2.4.1 p.46
 */
#define M_CAN_XIDFC_OFFSET 0x088U
#define M_CAN_XIDFC_RESET UINT32_C(0x00000000)
#define M_CAN_XIDFC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* LSE: Number of extended filter elements (two words each): 0 for no filter list, 1 to 64; more than 64 counts
 * as 64. Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value elements.
 * Contradictions of the manual: number_of_filters.
 */
#define M_CAN_XIDFC_LSE_Pos 16U
#define M_CAN_XIDFC_LSE_Msk UINT32_C(0x007F0000)
#define M_CAN_XIDFC_LSE_Width 7U
#define M_CAN_XIDFC_LSE_Access "rw:config"
#define M_CAN_XIDFC_LSE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_XIDFC_LSE_Pos) & M_CAN_XIDFC_LSE_Msk))
static inline uint32_t m_can_xidfc_lse_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_XIDFC_LSE_Msk) >> M_CAN_XIDFC_LSE_Pos);
}
static inline uint32_t m_can_xidfc_lse_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 127U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_XIDFC_LSE_Msk) | M_CAN_XIDFC_LSE_SET(value));
}
/* FLESA: Start of the extended filter list in Message RAM, as a 32-bit word address. Access rw:config. A write
 * has an effect only if config (CCCR.INIT && CCCR.CCE). Means value words.
 */
#define M_CAN_XIDFC_FLESA_Pos 2U
#define M_CAN_XIDFC_FLESA_Msk UINT32_C(0x0000FFFC)
#define M_CAN_XIDFC_FLESA_Width 14U
#define M_CAN_XIDFC_FLESA_Access "rw:config"
#define M_CAN_XIDFC_FLESA_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_XIDFC_FLESA_Pos) & M_CAN_XIDFC_FLESA_Msk))
static inline uint32_t m_can_xidfc_flesa_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_XIDFC_FLESA_Msk) >> M_CAN_XIDFC_FLESA_Pos);
}
static inline uint32_t m_can_xidfc_flesa_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 16383U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_XIDFC_FLESA_Msk) | M_CAN_XIDFC_FLESA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_xidfc_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->XIDFC;
    regs->XIDFC = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* XIDAM: Extended ID AND Mask.
 * Mask over the identifier of received extended frames before filtering, meant for SAE J1939. Filter elements of
 * type range_unmasked are exempt. The message is stored with its unmasked identifier.
 * Contradictions of the manual: bit_tables_missing, overview_page_garbled.
 * §2.3.23 Table 24 p.29; Table 1 p.6 (reset and access); §2.4.6 p.54; §3.4.1 p.66; §3.4.1.5 p.68
 */
#define M_CAN_XIDAM_OFFSET 0x090U
#define M_CAN_XIDAM_RESET UINT32_C(0x1FFFFFFF)
#define M_CAN_XIDAM_RESET_MASK UINT32_C(0xFFFFFFFF)
/* EIDM: Mask ANDed with the received 29-bit identifier; all ones switches the mask off. Access rw:config. A
 * write has an effect only if config (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_XIDAM_EIDM_Pos 0U
#define M_CAN_XIDAM_EIDM_Msk UINT32_C(0x1FFFFFFF)
#define M_CAN_XIDAM_EIDM_Width 29U
#define M_CAN_XIDAM_EIDM_Access "rw:config"
#define M_CAN_XIDAM_EIDM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_XIDAM_EIDM_Pos) & M_CAN_XIDAM_EIDM_Msk))
static inline uint32_t m_can_xidam_eidm_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_XIDAM_EIDM_Msk) >> M_CAN_XIDAM_EIDM_Pos);
}
static inline uint32_t m_can_xidam_eidm_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= UINT32_C(536870911));
    return (uint32_t)((reg & (uint32_t)~M_CAN_XIDAM_EIDM_Msk) | M_CAN_XIDAM_EIDM_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_xidam_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->XIDAM;
    regs->XIDAM = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* HPMS: High Priority Message Status.
 * Written each time a message matches a filter element that sets priority. Reset when CCCR.CCE is set.
 * Hazard: Do not acknowledge a message read through BIDX ahead of its turn; that would drop the older elements
 * of the FIFO.
 * Contradictions of the manual: bit_tables_missing, overview_page_garbled.
 * §2.3.24 Table 25 p.29; Table 1 p.6 (reset and access); §3.1.1 p.57; §3.6 p.78
 */
#define M_CAN_HPMS_OFFSET 0x094U
#define M_CAN_HPMS_RESET UINT32_C(0x00000000)
#define M_CAN_HPMS_RESET_MASK UINT32_C(0xFFFFFFFF)
/* FLST: Filter list of the matching element. Access ro. */
#define M_CAN_HPMS_FLST_Pos 15U
#define M_CAN_HPMS_FLST_Msk UINT32_C(0x00008000)
#define M_CAN_HPMS_FLST_Width 1U
#define M_CAN_HPMS_FLST_Access "ro"
static inline uint32_t m_can_hpms_flst_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_HPMS_FLST_Msk) >> M_CAN_HPMS_FLST_Pos);
}
/* FIDX: Index of the matching element, from 0 to the list size (SIDFC.LSS or XIDFC.LSE) minus 1. Access ro. */
#define M_CAN_HPMS_FIDX_Pos 8U
#define M_CAN_HPMS_FIDX_Msk UINT32_C(0x00007F00)
#define M_CAN_HPMS_FIDX_Width 7U
#define M_CAN_HPMS_FIDX_Access "ro"
static inline uint32_t m_can_hpms_fidx_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_HPMS_FIDX_Msk) >> M_CAN_HPMS_FIDX_Pos);
}
/* MSI: Where the message went. Access ro. */
#define M_CAN_HPMS_MSI_Pos 6U
#define M_CAN_HPMS_MSI_Msk UINT32_C(0x000000C0)
#define M_CAN_HPMS_MSI_Width 2U
#define M_CAN_HPMS_MSI_Access "ro"
static inline uint32_t m_can_hpms_msi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_HPMS_MSI_Msk) >> M_CAN_HPMS_MSI_Pos);
}
/* BIDX: Index of the Rx FIFO element that holds the message; valid if MSI is fifo_0 or fifo_1. Access ro. */
#define M_CAN_HPMS_BIDX_Pos 0U
#define M_CAN_HPMS_BIDX_Msk UINT32_C(0x0000003F)
#define M_CAN_HPMS_BIDX_Width 6U
#define M_CAN_HPMS_BIDX_Access "ro"
static inline uint32_t m_can_hpms_bidx_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_HPMS_BIDX_Msk) >> M_CAN_HPMS_BIDX_Pos);
}

/* NDAT1: New Data 1.
 * New Data flags of Rx Buffers 0 to 31. While a flag is set its buffer is locked and its filter element does not
 * match.
 * Hazard: Write only the flags of buffers that have been read; a written-back copy releases every buffer that
 * was set.
 * Contradictions of the manual: ndat_legend.
 * §2.3.25 Table 26 p.30; Table 1 p.6 (reset and access); §3.4.3 p.71; §3.4.4.1 p.72
 */
#define M_CAN_NDAT1_OFFSET 0x098U
#define M_CAN_NDAT1_RESET UINT32_C(0x00000000)
#define M_CAN_NDAT1_RESET_MASK UINT32_C(0xFFFFFFFF)
/* ND: The Rx Buffer of this number holds a new message. Write 1 to clear and to unlock the buffer. Not set for
 * debug messages. Access w1c. A flag: writing 1 clears it, writing 0 does nothing. Lane 0 is number 0 in the
 * first register.
 */
#define M_CAN_NDAT1_ND_Pos(lane) (0U + 1U * (lane))
#define M_CAN_NDAT1_ND_Msk(lane) ((uint32_t)(UINT32_C(0x00000001) << (1U * (lane))))
#define M_CAN_NDAT1_ND_Lanes 32U
#define M_CAN_NDAT1_ND_Width 1U
#define M_CAN_NDAT1_ND_Access "w1c"
static inline uint32_t m_can_ndat1_nd_get(uint32_t reg, unsigned int lane)
{
    M_CAN_ASSERT(lane < 32U);
    return (uint32_t)((reg & M_CAN_NDAT1_ND_Msk(lane)) >> M_CAN_NDAT1_ND_Pos(lane));
}
/* Clears the given flags and no others: one store, no read. */
static inline void m_can_ndat1_clear(m_can_regs_t *regs, uint32_t flags)
{
    regs->NDAT1 = (uint32_t)(flags & UINT32_C(0xFFFFFFFF));
}

/* NDAT2: New Data 2.
 * New Data flags of Rx Buffers 32 to 63. While a flag is set its buffer is locked and its filter element does
 * not match.
 * Hazard: Write only the flags of buffers that have been read; a written-back copy releases every buffer that
 * was set.
 * Contradictions of the manual: ndat_legend.
 * §2.3.26 Table 27 p.30; Table 1 p.6 (reset and access); §3.4.3 p.71; §3.4.4.1 p.72
 */
#define M_CAN_NDAT2_OFFSET 0x09CU
#define M_CAN_NDAT2_RESET UINT32_C(0x00000000)
#define M_CAN_NDAT2_RESET_MASK UINT32_C(0xFFFFFFFF)
/* ND: The Rx Buffer of this number holds a new message. Write 1 to clear and to unlock the buffer. Not set for
 * debug messages. Access w1c. A flag: writing 1 clears it, writing 0 does nothing. Lane 0 is number 32 in the
 * first register.
 */
#define M_CAN_NDAT2_ND_Pos(lane) (0U + 1U * (lane))
#define M_CAN_NDAT2_ND_Msk(lane) ((uint32_t)(UINT32_C(0x00000001) << (1U * (lane))))
#define M_CAN_NDAT2_ND_Lanes 32U
#define M_CAN_NDAT2_ND_Width 1U
#define M_CAN_NDAT2_ND_Access "w1c"
static inline uint32_t m_can_ndat2_nd_get(uint32_t reg, unsigned int lane)
{
    M_CAN_ASSERT(lane < 32U);
    return (uint32_t)((reg & M_CAN_NDAT2_ND_Msk(lane)) >> M_CAN_NDAT2_ND_Pos(lane));
}
/* Clears the given flags and no others: one store, no read. */
static inline void m_can_ndat2_clear(m_can_regs_t *regs, uint32_t flags)
{
    regs->NDAT2 = (uint32_t)(flags & UINT32_C(0xFFFFFFFF));
}

/* RXF0C: Rx FIFO 0 Configuration.
 * Place, size, watermark and mode of Rx FIFO 0.
 * Hazard: In overwrite mode start reading a full FIFO at least one element behind the get index; the oldest may
 * be overwritten meanwhile.
 * A write is dangerous: Received messages are written to the Message RAM at this unchecked address and length.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.27 Table 28 p.31; Table 1 p.6 (reset and access); §3.4.2 p.69; §3.4.2.2 p.70
 */
#define M_CAN_RXF0C_OFFSET 0x0A0U
#define M_CAN_RXF0C_RESET UINT32_C(0x00000000)
#define M_CAN_RXF0C_RESET_MASK UINT32_C(0xFFFFFFFF)
/* F0OM: Operation mode of Rx FIFO 0. Access rw:config. A write has an effect only if config (CCCR.INIT &&
 * CCCR.CCE).
 * Contradictions of the manual: field_name_misprints.
 */
#define M_CAN_RXF0C_F0OM_Pos 31U
#define M_CAN_RXF0C_F0OM_Msk UINT32_C(0x80000000)
#define M_CAN_RXF0C_F0OM_Width 1U
#define M_CAN_RXF0C_F0OM_Access "rw:config"
#define M_CAN_RXF0C_F0OM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXF0C_F0OM_Pos) & M_CAN_RXF0C_F0OM_Msk))
static inline uint32_t m_can_rxf0c_f0om_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF0C_F0OM_Msk) >> M_CAN_RXF0C_F0OM_Pos);
}
static inline uint32_t m_can_rxf0c_f0om_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXF0C_F0OM_Msk) | M_CAN_RXF0C_F0OM_SET(value));
}
/* F0WM: Fill level of Rx FIFO 0 that sets IR.RF0W, 1 to 64; 0 and more than 64 switch the watermark off. Access
 * rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value elements.
 */
#define M_CAN_RXF0C_F0WM_Pos 24U
#define M_CAN_RXF0C_F0WM_Msk UINT32_C(0x7F000000)
#define M_CAN_RXF0C_F0WM_Width 7U
#define M_CAN_RXF0C_F0WM_Access "rw:config"
#define M_CAN_RXF0C_F0WM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXF0C_F0WM_Pos) & M_CAN_RXF0C_F0WM_Msk))
static inline uint32_t m_can_rxf0c_f0wm_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF0C_F0WM_Msk) >> M_CAN_RXF0C_F0WM_Pos);
}
static inline uint32_t m_can_rxf0c_f0wm_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 127U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXF0C_F0WM_Msk) | M_CAN_RXF0C_F0WM_SET(value));
}
/* F0S: Number of elements of Rx FIFO 0: 0 for no FIFO, 1 to 64; more than 64 counts as 64. Elements count from
 * 0. Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value elements.
 */
#define M_CAN_RXF0C_F0S_Pos 16U
#define M_CAN_RXF0C_F0S_Msk UINT32_C(0x007F0000)
#define M_CAN_RXF0C_F0S_Width 7U
#define M_CAN_RXF0C_F0S_Access "rw:config"
#define M_CAN_RXF0C_F0S_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXF0C_F0S_Pos) & M_CAN_RXF0C_F0S_Msk))
static inline uint32_t m_can_rxf0c_f0s_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF0C_F0S_Msk) >> M_CAN_RXF0C_F0S_Pos);
}
static inline uint32_t m_can_rxf0c_f0s_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 127U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXF0C_F0S_Msk) | M_CAN_RXF0C_F0S_SET(value));
}
/* F0SA: Start of Rx FIFO 0 in Message RAM, as a 32-bit word address. Access rw:config. A write has an effect
 * only if config (CCCR.INIT && CCCR.CCE). Means value words.
 */
#define M_CAN_RXF0C_F0SA_Pos 2U
#define M_CAN_RXF0C_F0SA_Msk UINT32_C(0x0000FFFC)
#define M_CAN_RXF0C_F0SA_Width 14U
#define M_CAN_RXF0C_F0SA_Access "rw:config"
#define M_CAN_RXF0C_F0SA_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXF0C_F0SA_Pos) & M_CAN_RXF0C_F0SA_Msk))
static inline uint32_t m_can_rxf0c_f0sa_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF0C_F0SA_Msk) >> M_CAN_RXF0C_F0SA_Pos);
}
static inline uint32_t m_can_rxf0c_f0sa_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 16383U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXF0C_F0SA_Msk) | M_CAN_RXF0C_F0SA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_rxf0c_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->RXF0C;
    regs->RXF0C = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* RXF0S: Rx FIFO 0 Status.
 * Indices and fill level of Rx FIFO 0. Reset when CCCR.CCE is set.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.28 Table 29 p.32; Table 1 p.6 (reset and access); §3.4.2 p.69; §3.1.1 p.57
 */
#define M_CAN_RXF0S_OFFSET 0x0A4U
#define M_CAN_RXF0S_RESET UINT32_C(0x00000000)
#define M_CAN_RXF0S_RESET_MASK UINT32_C(0xFFFFFFFF)
/* RF0L: Copy of IR.RF0L: a message was lost; cleared by clearing IR.RF0L. Not set when a message is overwritten
 * in overwrite mode. Access ro.
 * Contradictions of the manual: lost_flags_and_cce.
 */
#define M_CAN_RXF0S_RF0L_Pos 25U
#define M_CAN_RXF0S_RF0L_Msk UINT32_C(0x02000000)
#define M_CAN_RXF0S_RF0L_Width 1U
#define M_CAN_RXF0S_RF0L_Access "ro"
static inline uint32_t m_can_rxf0s_rf0l_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF0S_RF0L_Msk) >> M_CAN_RXF0S_RF0L_Pos);
}
/* F0F: Rx FIFO 0 is full. The indices are equal both when it is full and when it is empty. Access ro. */
#define M_CAN_RXF0S_F0F_Pos 24U
#define M_CAN_RXF0S_F0F_Msk UINT32_C(0x01000000)
#define M_CAN_RXF0S_F0F_Width 1U
#define M_CAN_RXF0S_F0F_Access "ro"
static inline uint32_t m_can_rxf0s_f0f_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF0S_F0F_Msk) >> M_CAN_RXF0S_F0F_Pos);
}
/* F0PI: Put index of Rx FIFO 0, 0 to 63: the element that is written next. Access ro. */
#define M_CAN_RXF0S_F0PI_Pos 16U
#define M_CAN_RXF0S_F0PI_Msk UINT32_C(0x003F0000)
#define M_CAN_RXF0S_F0PI_Width 6U
#define M_CAN_RXF0S_F0PI_Access "ro"
static inline uint32_t m_can_rxf0s_f0pi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF0S_F0PI_Msk) >> M_CAN_RXF0S_F0PI_Pos);
}
/* F0GI: Get index of Rx FIFO 0, 0 to 63: the oldest element. Access ro. */
#define M_CAN_RXF0S_F0GI_Pos 8U
#define M_CAN_RXF0S_F0GI_Msk UINT32_C(0x00003F00)
#define M_CAN_RXF0S_F0GI_Width 6U
#define M_CAN_RXF0S_F0GI_Access "ro"
static inline uint32_t m_can_rxf0s_f0gi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF0S_F0GI_Msk) >> M_CAN_RXF0S_F0GI_Pos);
}
/* F0FL: Number of messages in Rx FIFO 0, 0 to 64. Access ro. Means value elements. */
#define M_CAN_RXF0S_F0FL_Pos 0U
#define M_CAN_RXF0S_F0FL_Msk UINT32_C(0x0000007F)
#define M_CAN_RXF0S_F0FL_Width 7U
#define M_CAN_RXF0S_F0FL_Access "ro"
static inline uint32_t m_can_rxf0s_f0fl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF0S_F0FL_Msk) >> M_CAN_RXF0S_F0FL_Pos);
}

/* RXF0A: Rx FIFO 0 Acknowledge.
 * Releases elements of Rx FIFO 0 that have been read.
 * Hazard: The written index is not checked. A wrong one moves the get index to a wrong place and loses messages.
 * Hazard: Every write moves the get index, a written-back copy too. Write only right after reading elements.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.29 Table 30 p.33; Table 1 p.6 (reset and access); §3.6 p.78
 */
#define M_CAN_RXF0A_OFFSET 0x0A8U
#define M_CAN_RXF0A_RESET UINT32_C(0x00000000)
#define M_CAN_RXF0A_RESET_MASK UINT32_C(0xFFFFFFFF)
/* F0AI: Index of the last element read from Rx FIFO 0. A write sets the get index RXF0S.F0GI to the element
 * behind it and updates the fill level RXF0S.F0FL; one write releases all elements up to this one. Access rwh.
 * Read and write, but hardware changes it too: writing back a stale value undoes the hardware.
 * Contradictions of the manual: acknowledge_target, field_name_misprints.
 */
#define M_CAN_RXF0A_F0AI_Pos 0U
#define M_CAN_RXF0A_F0AI_Msk UINT32_C(0x0000003F)
#define M_CAN_RXF0A_F0AI_Width 6U
#define M_CAN_RXF0A_F0AI_Access "rwh"
#define M_CAN_RXF0A_F0AI_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXF0A_F0AI_Pos) & M_CAN_RXF0A_F0AI_Msk))
static inline uint32_t m_can_rxf0a_f0ai_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF0A_F0AI_Msk) >> M_CAN_RXF0A_F0AI_Pos);
}
static inline uint32_t m_can_rxf0a_f0ai_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 63U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXF0A_F0AI_Msk) | M_CAN_RXF0A_F0AI_SET(value));
}
/* No read-modify-write: no value written to F0AI leaves it alone. Compose the whole value and store it. */

/* RXBC: Rx Buffer Configuration.
 * Place of the dedicated Rx Buffers. There is no size field; buffers exist as far as filter elements refer to
 * them, up to 64.
 * A write is dangerous: Received messages are written to the Message RAM from this unchecked address on.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.30 Table 31 p.33; Table 1 p.6 (reset and access); §3.4.3 p.71
 */
#define M_CAN_RXBC_OFFSET 0x0ACU
#define M_CAN_RXBC_RESET UINT32_C(0x00000000)
#define M_CAN_RXBC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* RBSA: Start of the Rx Buffers in Message RAM, as a 32-bit word address. Debug messages A, B and C are placed
 * from here too. Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value
 * words.
 */
#define M_CAN_RXBC_RBSA_Pos 2U
#define M_CAN_RXBC_RBSA_Msk UINT32_C(0x0000FFFC)
#define M_CAN_RXBC_RBSA_Width 14U
#define M_CAN_RXBC_RBSA_Access "rw:config"
#define M_CAN_RXBC_RBSA_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXBC_RBSA_Pos) & M_CAN_RXBC_RBSA_Msk))
static inline uint32_t m_can_rxbc_rbsa_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXBC_RBSA_Msk) >> M_CAN_RXBC_RBSA_Pos);
}
static inline uint32_t m_can_rxbc_rbsa_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 16383U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXBC_RBSA_Msk) | M_CAN_RXBC_RBSA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_rxbc_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->RXBC;
    regs->RXBC = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* RXF1C: Rx FIFO 1 Configuration.
 * Place, size, watermark and mode of Rx FIFO 1.
 * Hazard: In overwrite mode start reading a full FIFO at least one element behind the get index; the oldest may
 * be overwritten meanwhile.
 * A write is dangerous: Received messages are written to the Message RAM at this unchecked address and length.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.31 Table 32 p.34; Table 1 p.6 (reset and access); §3.4.2 p.69; §3.4.2.2 p.70
 */
#define M_CAN_RXF1C_OFFSET 0x0B0U
#define M_CAN_RXF1C_RESET UINT32_C(0x00000000)
#define M_CAN_RXF1C_RESET_MASK UINT32_C(0xFFFFFFFF)
/* F1OM: Operation mode of Rx FIFO 1. Access rw:config. A write has an effect only if config (CCCR.INIT &&
 * CCCR.CCE).
 */
#define M_CAN_RXF1C_F1OM_Pos 31U
#define M_CAN_RXF1C_F1OM_Msk UINT32_C(0x80000000)
#define M_CAN_RXF1C_F1OM_Width 1U
#define M_CAN_RXF1C_F1OM_Access "rw:config"
#define M_CAN_RXF1C_F1OM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXF1C_F1OM_Pos) & M_CAN_RXF1C_F1OM_Msk))
static inline uint32_t m_can_rxf1c_f1om_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF1C_F1OM_Msk) >> M_CAN_RXF1C_F1OM_Pos);
}
static inline uint32_t m_can_rxf1c_f1om_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXF1C_F1OM_Msk) | M_CAN_RXF1C_F1OM_SET(value));
}
/* F1WM: Fill level of Rx FIFO 1 that sets IR.RF1W, 1 to 64; 0 and more than 64 switch the watermark off. Access
 * rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value elements.
 */
#define M_CAN_RXF1C_F1WM_Pos 24U
#define M_CAN_RXF1C_F1WM_Msk UINT32_C(0x7F000000)
#define M_CAN_RXF1C_F1WM_Width 7U
#define M_CAN_RXF1C_F1WM_Access "rw:config"
#define M_CAN_RXF1C_F1WM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXF1C_F1WM_Pos) & M_CAN_RXF1C_F1WM_Msk))
static inline uint32_t m_can_rxf1c_f1wm_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF1C_F1WM_Msk) >> M_CAN_RXF1C_F1WM_Pos);
}
static inline uint32_t m_can_rxf1c_f1wm_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 127U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXF1C_F1WM_Msk) | M_CAN_RXF1C_F1WM_SET(value));
}
/* F1S: Number of elements of Rx FIFO 1: 0 for no FIFO, 1 to 64; more than 64 counts as 64. Elements count from
 * 0. Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value elements.
 */
#define M_CAN_RXF1C_F1S_Pos 16U
#define M_CAN_RXF1C_F1S_Msk UINT32_C(0x007F0000)
#define M_CAN_RXF1C_F1S_Width 7U
#define M_CAN_RXF1C_F1S_Access "rw:config"
#define M_CAN_RXF1C_F1S_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXF1C_F1S_Pos) & M_CAN_RXF1C_F1S_Msk))
static inline uint32_t m_can_rxf1c_f1s_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF1C_F1S_Msk) >> M_CAN_RXF1C_F1S_Pos);
}
static inline uint32_t m_can_rxf1c_f1s_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 127U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXF1C_F1S_Msk) | M_CAN_RXF1C_F1S_SET(value));
}
/* F1SA: Start of Rx FIFO 1 in Message RAM, as a 32-bit word address. Access rw:config. A write has an effect
 * only if config (CCCR.INIT && CCCR.CCE). Means value words.
 */
#define M_CAN_RXF1C_F1SA_Pos 2U
#define M_CAN_RXF1C_F1SA_Msk UINT32_C(0x0000FFFC)
#define M_CAN_RXF1C_F1SA_Width 14U
#define M_CAN_RXF1C_F1SA_Access "rw:config"
#define M_CAN_RXF1C_F1SA_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXF1C_F1SA_Pos) & M_CAN_RXF1C_F1SA_Msk))
static inline uint32_t m_can_rxf1c_f1sa_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF1C_F1SA_Msk) >> M_CAN_RXF1C_F1SA_Pos);
}
static inline uint32_t m_can_rxf1c_f1sa_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 16383U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXF1C_F1SA_Msk) | M_CAN_RXF1C_F1SA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_rxf1c_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->RXF1C;
    regs->RXF1C = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* RXF1S: Rx FIFO 1 Status.
 * Indices and fill level of Rx FIFO 1, and the state of debug message reception. Reset when CCCR.CCE is set.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.32 Table 33 p.34; §2.3.32 p.35; Table 1 p.6 (reset and access); §3.4.2 p.69; §3.1.1 p.57
 */
#define M_CAN_RXF1S_OFFSET 0x0B4U
#define M_CAN_RXF1S_RESET UINT32_C(0x00000000)
#define M_CAN_RXF1S_RESET_MASK UINT32_C(0xFFFFFFFF)
/* RF1L: Copy of IR.RF1L: a message was lost; cleared by clearing IR.RF1L. Not set when a message is overwritten
 * in overwrite mode. Access ro.
 * Contradictions of the manual: lost_flags_and_cce.
 */
#define M_CAN_RXF1S_RF1L_Pos 25U
#define M_CAN_RXF1S_RF1L_Msk UINT32_C(0x02000000)
#define M_CAN_RXF1S_RF1L_Width 1U
#define M_CAN_RXF1S_RF1L_Access "ro"
static inline uint32_t m_can_rxf1s_rf1l_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF1S_RF1L_Msk) >> M_CAN_RXF1S_RF1L_Pos);
}
/* F1F: Rx FIFO 1 is full. The indices are equal both when it is full and when it is empty. Access ro. */
#define M_CAN_RXF1S_F1F_Pos 24U
#define M_CAN_RXF1S_F1F_Msk UINT32_C(0x01000000)
#define M_CAN_RXF1S_F1F_Width 1U
#define M_CAN_RXF1S_F1F_Access "ro"
static inline uint32_t m_can_rxf1s_f1f_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF1S_F1F_Msk) >> M_CAN_RXF1S_F1F_Pos);
}
/* F1PI: Put index of Rx FIFO 1, 0 to 63: the element that is written next. Access ro. */
#define M_CAN_RXF1S_F1PI_Pos 16U
#define M_CAN_RXF1S_F1PI_Msk UINT32_C(0x003F0000)
#define M_CAN_RXF1S_F1PI_Width 6U
#define M_CAN_RXF1S_F1PI_Access "ro"
static inline uint32_t m_can_rxf1s_f1pi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF1S_F1PI_Msk) >> M_CAN_RXF1S_F1PI_Pos);
}
/* F1GI: Get index of Rx FIFO 1, 0 to 63: the oldest element. Access ro. */
#define M_CAN_RXF1S_F1GI_Pos 8U
#define M_CAN_RXF1S_F1GI_Msk UINT32_C(0x00003F00)
#define M_CAN_RXF1S_F1GI_Width 6U
#define M_CAN_RXF1S_F1GI_Access "ro"
static inline uint32_t m_can_rxf1s_f1gi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF1S_F1GI_Msk) >> M_CAN_RXF1S_F1GI_Pos);
}
/* F1FL: Number of messages in Rx FIFO 1, 0 to 64. Access ro. Means value elements. */
#define M_CAN_RXF1S_F1FL_Pos 0U
#define M_CAN_RXF1S_F1FL_Msk UINT32_C(0x0000007F)
#define M_CAN_RXF1S_F1FL_Width 7U
#define M_CAN_RXF1S_F1FL_Access "ro"
static inline uint32_t m_can_rxf1s_f1fl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF1S_F1FL_Msk) >> M_CAN_RXF1S_F1FL_Pos);
}
/* DMS: Debug message status. Access ro.
 * Contradictions of the manual: dms_reset.
 * §2.3.32 p.34; §3.4.4.2 p.72
 */
#define M_CAN_RXF1S_DMS_Pos 30U
#define M_CAN_RXF1S_DMS_Msk UINT32_C(0xC0000000)
#define M_CAN_RXF1S_DMS_Width 2U
#define M_CAN_RXF1S_DMS_Access "ro"
static inline uint32_t m_can_rxf1s_dms_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF1S_DMS_Msk) >> M_CAN_RXF1S_DMS_Pos);
}

/* RXF1A: Rx FIFO 1 Acknowledge.
 * Releases elements of Rx FIFO 1 that have been read.
 * Hazard: The written index is not checked. A wrong one moves the get index to a wrong place and loses messages.
 * Hazard: Every write moves the get index, a written-back copy too. Write only right after reading elements.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.33 Table 34 p.35; Table 1 p.6 (reset and access); §3.6 p.78
 */
#define M_CAN_RXF1A_OFFSET 0x0B8U
#define M_CAN_RXF1A_RESET UINT32_C(0x00000000)
#define M_CAN_RXF1A_RESET_MASK UINT32_C(0xFFFFFFFF)
/* F1AI: Index of the last element read from Rx FIFO 1. A write sets the get index RXF1S.F1GI to the element
 * behind it and updates the fill level RXF1S.F1FL; one write releases all elements up to this one. Access rwh.
 * Read and write, but hardware changes it too: writing back a stale value undoes the hardware.
 * Contradictions of the manual: acknowledge_target, field_name_misprints.
 */
#define M_CAN_RXF1A_F1AI_Pos 0U
#define M_CAN_RXF1A_F1AI_Msk UINT32_C(0x0000003F)
#define M_CAN_RXF1A_F1AI_Width 6U
#define M_CAN_RXF1A_F1AI_Access "rwh"
#define M_CAN_RXF1A_F1AI_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXF1A_F1AI_Pos) & M_CAN_RXF1A_F1AI_Msk))
static inline uint32_t m_can_rxf1a_f1ai_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXF1A_F1AI_Msk) >> M_CAN_RXF1A_F1AI_Pos);
}
static inline uint32_t m_can_rxf1a_f1ai_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 63U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXF1A_F1AI_Msk) | M_CAN_RXF1A_F1AI_SET(value));
}
/* No read-modify-write: no value written to F1AI leaves it alone. Compose the whole value and store it. */

/* RXESC: Rx Buffer / FIFO Element Size Configuration.
 * Data field sizes of Rx Buffers and Rx FIFOs. Of a longer message only the configured number of bytes is
 * stored. Sizes above 8 bytes are for CAN FD.
 * A write is dangerous: Larger elements make the Rx Handler write further into the Message RAM than the section
 * may reach.
 * Contradictions of the manual: bit_tables_missing, undefined_legend.
 * §2.3.34 Table 35 p.36; Table 1 p.6 (reset and access)
 */
#define M_CAN_RXESC_OFFSET 0x0BCU
#define M_CAN_RXESC_RESET UINT32_C(0x00000000)
#define M_CAN_RXESC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* RBDS: Data field size of a dedicated Rx Buffer. Access rw:config. A write has an effect only if config
 * (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_RXESC_RBDS_Pos 8U
#define M_CAN_RXESC_RBDS_Msk UINT32_C(0x00000700)
#define M_CAN_RXESC_RBDS_Width 3U
#define M_CAN_RXESC_RBDS_Access "rw:config"
#define M_CAN_RXESC_RBDS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXESC_RBDS_Pos) & M_CAN_RXESC_RBDS_Msk))
static inline uint32_t m_can_rxesc_rbds_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXESC_RBDS_Msk) >> M_CAN_RXESC_RBDS_Pos);
}
static inline uint32_t m_can_rxesc_rbds_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXESC_RBDS_Msk) | M_CAN_RXESC_RBDS_SET(value));
}
/* F1DS: Data field size of an Rx FIFO 1 element. Access rw:config. A write has an effect only if config
 * (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_RXESC_F1DS_Pos 4U
#define M_CAN_RXESC_F1DS_Msk UINT32_C(0x00000070)
#define M_CAN_RXESC_F1DS_Width 3U
#define M_CAN_RXESC_F1DS_Access "rw:config"
#define M_CAN_RXESC_F1DS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXESC_F1DS_Pos) & M_CAN_RXESC_F1DS_Msk))
static inline uint32_t m_can_rxesc_f1ds_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXESC_F1DS_Msk) >> M_CAN_RXESC_F1DS_Pos);
}
static inline uint32_t m_can_rxesc_f1ds_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXESC_F1DS_Msk) | M_CAN_RXESC_F1DS_SET(value));
}
/* F0DS: Data field size of an Rx FIFO 0 element. Access rw:config. A write has an effect only if config
 * (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_RXESC_F0DS_Pos 0U
#define M_CAN_RXESC_F0DS_Msk UINT32_C(0x00000007)
#define M_CAN_RXESC_F0DS_Width 3U
#define M_CAN_RXESC_F0DS_Access "rw:config"
#define M_CAN_RXESC_F0DS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RXESC_F0DS_Pos) & M_CAN_RXESC_F0DS_Msk))
static inline uint32_t m_can_rxesc_f0ds_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RXESC_F0DS_Msk) >> M_CAN_RXESC_F0DS_Pos);
}
static inline uint32_t m_can_rxesc_f0ds_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RXESC_F0DS_Msk) | M_CAN_RXESC_F0DS_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_rxesc_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->RXESC;
    regs->RXESC = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* TXBC: Tx Buffer Configuration.
 * Place of the Tx Buffers and their division into dedicated buffers, which come first, and a Tx FIFO or Tx
 * Queue.
 * Hazard: NDTB + TFQS must not exceed 32; this is not checked.
 * A write is dangerous: The Tx Handler reads messages to send from the Message RAM at this unchecked address and
 * length.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.35 Table 36 p.37; Table 1 p.6 (reset and access); §3.5.5 p.76
 */
#define M_CAN_TXBC_OFFSET 0x0C0U
#define M_CAN_TXBC_RESET UINT32_C(0x00000000)
#define M_CAN_TXBC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TFQM: Whether the buffers behind the dedicated ones are a FIFO or a queue. Access rw:config. A write has an
 * effect only if config (CCCR.INIT && CCCR.CCE).
 */
#define M_CAN_TXBC_TFQM_Pos 30U
#define M_CAN_TXBC_TFQM_Msk UINT32_C(0x40000000)
#define M_CAN_TXBC_TFQM_Width 1U
#define M_CAN_TXBC_TFQM_Access "rw:config"
#define M_CAN_TXBC_TFQM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TXBC_TFQM_Pos) & M_CAN_TXBC_TFQM_Msk))
static inline uint32_t m_can_txbc_tfqm_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXBC_TFQM_Msk) >> M_CAN_TXBC_TFQM_Pos);
}
static inline uint32_t m_can_txbc_tfqm_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TXBC_TFQM_Msk) | M_CAN_TXBC_TFQM_SET(value));
}
/* TFQS: Number of Tx Buffers of the Tx FIFO or Tx Queue: 0 for none, 1 to 32; more than 32 counts as 32. Access
 * rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value elements.
 */
#define M_CAN_TXBC_TFQS_Pos 24U
#define M_CAN_TXBC_TFQS_Msk UINT32_C(0x3F000000)
#define M_CAN_TXBC_TFQS_Width 6U
#define M_CAN_TXBC_TFQS_Access "rw:config"
#define M_CAN_TXBC_TFQS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TXBC_TFQS_Pos) & M_CAN_TXBC_TFQS_Msk))
static inline uint32_t m_can_txbc_tfqs_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXBC_TFQS_Msk) >> M_CAN_TXBC_TFQS_Pos);
}
static inline uint32_t m_can_txbc_tfqs_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 63U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TXBC_TFQS_Msk) | M_CAN_TXBC_TFQS_SET(value));
}
/* NDTB: Number of dedicated Tx Buffers: 0 for none, 1 to 32; more than 32 counts as 32. Access rw:config. A
 * write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value elements.
 */
#define M_CAN_TXBC_NDTB_Pos 16U
#define M_CAN_TXBC_NDTB_Msk UINT32_C(0x003F0000)
#define M_CAN_TXBC_NDTB_Width 6U
#define M_CAN_TXBC_NDTB_Access "rw:config"
#define M_CAN_TXBC_NDTB_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TXBC_NDTB_Pos) & M_CAN_TXBC_NDTB_Msk))
static inline uint32_t m_can_txbc_ndtb_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXBC_NDTB_Msk) >> M_CAN_TXBC_NDTB_Pos);
}
static inline uint32_t m_can_txbc_ndtb_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 63U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TXBC_NDTB_Msk) | M_CAN_TXBC_NDTB_SET(value));
}
/* TBSA: Start of the Tx Buffers in Message RAM, as a 32-bit word address. Access rw:config. A write has an
 * effect only if config (CCCR.INIT && CCCR.CCE). Means value words.
 */
#define M_CAN_TXBC_TBSA_Pos 2U
#define M_CAN_TXBC_TBSA_Msk UINT32_C(0x0000FFFC)
#define M_CAN_TXBC_TBSA_Width 14U
#define M_CAN_TXBC_TBSA_Access "rw:config"
#define M_CAN_TXBC_TBSA_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TXBC_TBSA_Pos) & M_CAN_TXBC_TBSA_Msk))
static inline uint32_t m_can_txbc_tbsa_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXBC_TBSA_Msk) >> M_CAN_TXBC_TBSA_Pos);
}
static inline uint32_t m_can_txbc_tbsa_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 16383U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TXBC_TBSA_Msk) | M_CAN_TXBC_TBSA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_txbc_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->TXBC;
    regs->TXBC = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* TXFQS: Tx FIFO/Queue Status.
 * Indices and free level of the Tx FIFO or Tx Queue. Indices count from the first dedicated Tx Buffer: with 12
 * dedicated buffers, put index 15 is the fourth buffer of the FIFO. Reset when CCCR.CCE is set.
 * Hazard: The status follows TXBRP, which a running Tx scan may not have updated yet after an add or
 * cancellation request.
 * Contradictions of the manual: bit_tables_missing.
 * §2.3.36 Table 37 p.38; Table 1 p.6 (reset and access); §3.5.3 p.75; §3.5.4 p.76; §3.1.1 p.57
 */
#define M_CAN_TXFQS_OFFSET 0x0C4U
#define M_CAN_TXFQS_RESET UINT32_C(0x00000000)
#define M_CAN_TXFQS_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TFQF: The Tx FIFO or Tx Queue is full; no further message may be written. Access ro. */
#define M_CAN_TXFQS_TFQF_Pos 21U
#define M_CAN_TXFQS_TFQF_Msk UINT32_C(0x00200000)
#define M_CAN_TXFQS_TFQF_Width 1U
#define M_CAN_TXFQS_TFQF_Access "ro"
static inline uint32_t m_can_txfqs_tfqf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXFQS_TFQF_Msk) >> M_CAN_TXFQS_TFQF_Pos);
}
/* TFQPI: Put index, 0 to 31: the Tx Buffer to be written next. In a queue the free buffer with the lowest
 * number, though any buffer without pending request may be used; invalid while a queue is full. Access ro.
 */
#define M_CAN_TXFQS_TFQPI_Pos 16U
#define M_CAN_TXFQS_TFQPI_Msk UINT32_C(0x001F0000)
#define M_CAN_TXFQS_TFQPI_Width 5U
#define M_CAN_TXFQS_TFQPI_Access "ro"
static inline uint32_t m_can_txfqs_tfqpi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXFQS_TFQPI_Msk) >> M_CAN_TXFQS_TFQPI_Pos);
}
/* TFGI: Get index of the Tx FIFO, 0 to 31: the Tx Buffer to be sent next; if that one is cancelled, it moves to
 * the next pending one. 0 with a Tx Queue. Access ro.
 * Contradictions of the manual: field_name_misprints.
 */
#define M_CAN_TXFQS_TFGI_Pos 8U
#define M_CAN_TXFQS_TFGI_Msk UINT32_C(0x00001F00)
#define M_CAN_TXFQS_TFGI_Width 5U
#define M_CAN_TXFQS_TFGI_Access "ro"
static inline uint32_t m_can_txfqs_tfgi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXFQS_TFGI_Msk) >> M_CAN_TXFQS_TFGI_Pos);
}
/* TFFL: Number of free Tx FIFO elements, 0 to 32. 0 with a Tx Queue. Access ro. Means value elements.
 * Contradictions of the manual: tx_fifo_free_level.
 */
#define M_CAN_TXFQS_TFFL_Pos 0U
#define M_CAN_TXFQS_TFFL_Msk UINT32_C(0x0000003F)
#define M_CAN_TXFQS_TFFL_Width 6U
#define M_CAN_TXFQS_TFFL_Access "ro"
static inline uint32_t m_can_txfqs_tffl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXFQS_TFFL_Msk) >> M_CAN_TXFQS_TFFL_Pos);
}

/* TXESC: Tx Buffer Element Size Configuration.
 * Data field size of all Tx Buffers. If a message's DLC asks for more bytes than that, the missing ones are sent
 * as 0xCC. Sizes above 8 bytes are for CAN FD.
 * A write is dangerous: Larger elements make the Tx Handler read further into the Message RAM than the section
 * may reach.
 * Contradictions of the manual: bit_tables_missing, undefined_legend.
 * §2.3.37 Table 38 p.39; Table 1 p.6 (reset and access)
 */
#define M_CAN_TXESC_OFFSET 0x0C8U
#define M_CAN_TXESC_RESET UINT32_C(0x00000000)
#define M_CAN_TXESC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TBDS: Data field size of a Tx Buffer. Access rw:config. A write has an effect only if config (CCCR.INIT &&
 * CCCR.CCE).
 */
#define M_CAN_TXESC_TBDS_Pos 0U
#define M_CAN_TXESC_TBDS_Msk UINT32_C(0x00000007)
#define M_CAN_TXESC_TBDS_Width 3U
#define M_CAN_TXESC_TBDS_Access "rw:config"
#define M_CAN_TXESC_TBDS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TXESC_TBDS_Pos) & M_CAN_TXESC_TBDS_Msk))
static inline uint32_t m_can_txesc_tbds_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXESC_TBDS_Msk) >> M_CAN_TXESC_TBDS_Pos);
}
static inline uint32_t m_can_txesc_tbds_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TXESC_TBDS_Msk) | M_CAN_TXESC_TBDS_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_txesc_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->TXESC;
    regs->TXESC = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* TXBRP: Tx Buffer Request Pending.
 * Pending transmission requests. Every change starts a Tx scan for the message with the lowest identifier. Reset
 * when CCCR.CCE is set and held in reset in Bus Monitoring Mode.
 * Hazard: Requests set during a Tx scan are not part of that scan; cancelling such a request takes effect at
 * once.
 * Contradictions of the manual: bit_tables_missing, monitoring_and_loop_back, overview_page_turned.
 * §2.3.38 Table 39 p.40; Table 1 p.6 (reset and access); §3.1.1 p.57; §3.1.6 p.61
 */
#define M_CAN_TXBRP_OFFSET 0x0CCU
#define M_CAN_TXBRP_RESET UINT32_C(0x00000000)
#define M_CAN_TXBRP_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TRP: The Tx Buffer of this number has a pending request, set through TXBAR for configured buffers only.
 * Cleared when the message has been sent or cancelled; when it is cancelled during transmission, at the end of
 * that transmission. Access ro. Lane 0 is number 0 in the first register.
 */
#define M_CAN_TXBRP_TRP_Pos(lane) (0U + 1U * (lane))
#define M_CAN_TXBRP_TRP_Msk(lane) ((uint32_t)(UINT32_C(0x00000001) << (1U * (lane))))
#define M_CAN_TXBRP_TRP_Lanes 32U
#define M_CAN_TXBRP_TRP_Width 1U
#define M_CAN_TXBRP_TRP_Access "ro"
static inline uint32_t m_can_txbrp_trp_get(uint32_t reg, unsigned int lane)
{
    M_CAN_ASSERT(lane < 32U);
    return (uint32_t)((reg & M_CAN_TXBRP_TRP_Msk(lane)) >> M_CAN_TXBRP_TRP_Pos(lane));
}

/* TXBAR: Tx Buffer Add Request.
 * Requests transmissions, of several Tx Buffers with one write if wanted. Takes no writes while CCCR.CCE is 1.
 * Hazard: A bit clears at once when no Tx scan runs, else at the end of the scan. Follow a request in TXBRP and
 * TXBTO, not here.
 * Hazard: Messages with equal identifiers in dedicated buffers have to be requested in ascending buffer order or
 * with one write.
 * Contradictions of the manual: overview_page_turned.
 * §2.3.39 Table 40 p.41; Table 1 p.6 (reset and access); §2.3.41 p.42; §3.1.1 p.57; §3.5.2 p.75
 */
#define M_CAN_TXBAR_OFFSET 0x0D0U
#define M_CAN_TXBAR_RESET UINT32_C(0x00000000)
#define M_CAN_TXBAR_RESET_MASK UINT32_C(0xFFFFFFFF)
/* AR: Write 1 to request transmission of the Tx Buffer of this number; 0 does nothing. Ignored if a request is
 * pending or the buffer is not configured in TXBC. Also clears the buffer's bits in TXBTO and TXBCF. Access
 * w1s:handlers_active. A request: writing 1 makes it, writing 0 does nothing, hardware clears it. A write has an
 * effect only if handlers_active (!CCCR.CCE). Lane 0 is number 0 in the first register.
 * Contradictions of the manual: add_request_visibility.
 */
#define M_CAN_TXBAR_AR_Pos(lane) (0U + 1U * (lane))
#define M_CAN_TXBAR_AR_Msk(lane) ((uint32_t)(UINT32_C(0x00000001) << (1U * (lane))))
#define M_CAN_TXBAR_AR_Lanes 32U
#define M_CAN_TXBAR_AR_Width 1U
#define M_CAN_TXBAR_AR_Access "w1s:handlers_active"
static inline uint32_t m_can_txbar_ar_get(uint32_t reg, unsigned int lane)
{
    M_CAN_ASSERT(lane < 32U);
    return (uint32_t)((reg & M_CAN_TXBAR_AR_Msk(lane)) >> M_CAN_TXBAR_AR_Pos(lane));
}
/* Makes the given requests and withdraws none: one store, no read. */
static inline void m_can_txbar_request(m_can_regs_t *regs, uint32_t requests)
{
    regs->TXBAR = (uint32_t)((requests & UINT32_C(0xFFFFFFFF)));
}

/* TXBCR: Tx Buffer Cancellation Request.
 * Requests cancellation of transmissions. Takes no writes while CCCR.CCE is 1. Not intended for Tx FIFO buffers.
 * Hazard: A transmission in progress is not interrupted. When TXBCF reports the end, TXBTO tells whether the
 * message was sent anyway.
 * Hazard: After cancelling a message that was about to start, this node starts no other one for a short time.
 * Contradictions of the manual: overview_page_turned.
 * §2.3.40 Table 41 p.41; Table 1 p.6 (reset and access); §3.5.7 p.77; §3.1.1 p.57
 */
#define M_CAN_TXBCR_OFFSET 0x0D4U
#define M_CAN_TXBCR_RESET UINT32_C(0x00000000)
#define M_CAN_TXBCR_RESET_MASK UINT32_C(0xFFFFFFFF)
/* CR: Write 1 to cancel the request of the Tx Buffer of this number; 0 does nothing. Ignored if the buffer is
 * not configured in TXBC. Reads 1 until the buffer's bit in TXBRP is cleared. Access w1s:handlers_active. A
 * request: writing 1 makes it, writing 0 does nothing, hardware clears it. A write has an effect only if
 * handlers_active (!CCCR.CCE). Lane 0 is number 0 in the first register.
 */
#define M_CAN_TXBCR_CR_Pos(lane) (0U + 1U * (lane))
#define M_CAN_TXBCR_CR_Msk(lane) ((uint32_t)(UINT32_C(0x00000001) << (1U * (lane))))
#define M_CAN_TXBCR_CR_Lanes 32U
#define M_CAN_TXBCR_CR_Width 1U
#define M_CAN_TXBCR_CR_Access "w1s:handlers_active"
static inline uint32_t m_can_txbcr_cr_get(uint32_t reg, unsigned int lane)
{
    M_CAN_ASSERT(lane < 32U);
    return (uint32_t)((reg & M_CAN_TXBCR_CR_Msk(lane)) >> M_CAN_TXBCR_CR_Pos(lane));
}
/* Makes the given requests and withdraws none: one store, no read. */
static inline void m_can_txbcr_request(m_can_regs_t *regs, uint32_t requests)
{
    regs->TXBCR = (uint32_t)((requests & UINT32_C(0xFFFFFFFF)));
}

/* TXBTO: Tx Buffer Transmission Occurred.
 * Successful transmissions. Reset when CCCR.CCE is set.
 * Contradictions of the manual: bit_tables_missing, overview_page_turned.
 * §2.3.41 Table 42 p.42; Table 1 p.6 (reset and access); §3.1.1 p.57
 */
#define M_CAN_TXBTO_OFFSET 0x0D8U
#define M_CAN_TXBTO_RESET UINT32_C(0x00000000)
#define M_CAN_TXBTO_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TO: The message of the Tx Buffer of this number was sent. Cleared by the next request for the buffer in TXBAR.
 * Access ro. Lane 0 is number 0 in the first register.
 */
#define M_CAN_TXBTO_TO_Pos(lane) (0U + 1U * (lane))
#define M_CAN_TXBTO_TO_Msk(lane) ((uint32_t)(UINT32_C(0x00000001) << (1U * (lane))))
#define M_CAN_TXBTO_TO_Lanes 32U
#define M_CAN_TXBTO_TO_Width 1U
#define M_CAN_TXBTO_TO_Access "ro"
static inline uint32_t m_can_txbto_to_get(uint32_t reg, unsigned int lane)
{
    M_CAN_ASSERT(lane < 32U);
    return (uint32_t)((reg & M_CAN_TXBTO_TO_Msk(lane)) >> M_CAN_TXBTO_TO_Pos(lane));
}

/* TXBCF: Tx Buffer Cancellation Finished.
 * Finished cancellations, and in DAR mode unsuccessful transmissions. Reset when CCCR.CCE is set.
 * Contradictions of the manual: overview_page_turned.
 * §2.3.42 Table 43 p.42; Table 1 p.6 (reset and access); §2.3.38 p.40; §3.1.7.1 p.62; §3.1.1 p.57
 */
#define M_CAN_TXBCF_OFFSET 0x0DCU
#define M_CAN_TXBCF_RESET UINT32_C(0x00000000)
#define M_CAN_TXBCF_RESET_MASK UINT32_C(0xFFFFFFFF)
/* CF: A cancellation requested for the Tx Buffer of this number is finished; set at once if no request was
 * pending. Cleared by the next request for the buffer in TXBAR. Access ro. Lane 0 is number 0 in the first
 * register.
 * Contradictions of the manual: dar_event_type, cancellation_finished_after_success.
 */
#define M_CAN_TXBCF_CF_Pos(lane) (0U + 1U * (lane))
#define M_CAN_TXBCF_CF_Msk(lane) ((uint32_t)(UINT32_C(0x00000001) << (1U * (lane))))
#define M_CAN_TXBCF_CF_Lanes 32U
#define M_CAN_TXBCF_CF_Width 1U
#define M_CAN_TXBCF_CF_Access "ro"
static inline uint32_t m_can_txbcf_cf_get(uint32_t reg, unsigned int lane)
{
    M_CAN_ASSERT(lane < 32U);
    return (uint32_t)((reg & M_CAN_TXBCF_CF_Msk(lane)) >> M_CAN_TXBCF_CF_Pos(lane));
}

/* TXBTIE: Tx Buffer Transmission Interrupt Enable.
 * Selects the Tx Buffers whose transmission raises the transmission completed interrupt (IR.TC).
 * Contradictions of the manual: bit_tables_missing, overview_page_turned.
 * §2.3.43 Table 44 p.43; Table 1 p.6 (reset and access)
 */
#define M_CAN_TXBTIE_OFFSET 0x0E0U
#define M_CAN_TXBTIE_RESET UINT32_C(0x00000000)
#define M_CAN_TXBTIE_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TIE: Enables the transmission interrupt of the Tx Buffer of this number. Access rw. Lane 0 is number 0 in the
 * first register.
 * Contradictions of the manual: garbled_letters.
 */
#define M_CAN_TXBTIE_TIE_Pos(lane) (0U + 1U * (lane))
#define M_CAN_TXBTIE_TIE_Msk(lane) ((uint32_t)(UINT32_C(0x00000001) << (1U * (lane))))
#define M_CAN_TXBTIE_TIE_Lanes 32U
#define M_CAN_TXBTIE_TIE_Width 1U
#define M_CAN_TXBTIE_TIE_Access "rw"
#define M_CAN_TXBTIE_TIE_SET(lane, value) ((uint32_t)(((uint32_t)(value) << M_CAN_TXBTIE_TIE_Pos(lane)) & M_CAN_TXBTIE_TIE_Msk(lane)))
static inline uint32_t m_can_txbtie_tie_get(uint32_t reg, unsigned int lane)
{
    M_CAN_ASSERT(lane < 32U);
    return (uint32_t)((reg & M_CAN_TXBTIE_TIE_Msk(lane)) >> M_CAN_TXBTIE_TIE_Pos(lane));
}
static inline uint32_t m_can_txbtie_tie_set(uint32_t reg, unsigned int lane, uint32_t value)
{
    M_CAN_ASSERT(lane < 32U);
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TXBTIE_TIE_Msk(lane)) | M_CAN_TXBTIE_TIE_SET(lane, value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_txbtie_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->TXBTIE;
    regs->TXBTIE = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* TXBCIE: Tx Buffer Cancellation Finished Interrupt Enable.
 * Selects the Tx Buffers whose finished cancellation raises the cancellation finished interrupt (IR.TCF).
 * Contradictions of the manual: bit_tables_missing, overview_page_turned.
 * §2.3.44 Table 45 p.43; Table 1 p.6 (reset and access)
 */
#define M_CAN_TXBCIE_OFFSET 0x0E4U
#define M_CAN_TXBCIE_RESET UINT32_C(0x00000000)
#define M_CAN_TXBCIE_RESET_MASK UINT32_C(0xFFFFFFFF)
/* CFIE: Enables the cancellation finished interrupt of the Tx Buffer of this number. Access rw. Lane 0 is number
 * 0 in the first register.
 */
#define M_CAN_TXBCIE_CFIE_Pos(lane) (0U + 1U * (lane))
#define M_CAN_TXBCIE_CFIE_Msk(lane) ((uint32_t)(UINT32_C(0x00000001) << (1U * (lane))))
#define M_CAN_TXBCIE_CFIE_Lanes 32U
#define M_CAN_TXBCIE_CFIE_Width 1U
#define M_CAN_TXBCIE_CFIE_Access "rw"
#define M_CAN_TXBCIE_CFIE_SET(lane, value) ((uint32_t)(((uint32_t)(value) << M_CAN_TXBCIE_CFIE_Pos(lane)) & M_CAN_TXBCIE_CFIE_Msk(lane)))
static inline uint32_t m_can_txbcie_cfie_get(uint32_t reg, unsigned int lane)
{
    M_CAN_ASSERT(lane < 32U);
    return (uint32_t)((reg & M_CAN_TXBCIE_CFIE_Msk(lane)) >> M_CAN_TXBCIE_CFIE_Pos(lane));
}
static inline uint32_t m_can_txbcie_cfie_set(uint32_t reg, unsigned int lane, uint32_t value)
{
    M_CAN_ASSERT(lane < 32U);
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TXBCIE_CFIE_Msk(lane)) | M_CAN_TXBCIE_CFIE_SET(lane, value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_txbcie_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->TXBCIE;
    regs->TXBCIE = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* TXEFC: Tx Event FIFO Configuration.
 * Place, size and watermark of the Tx Event FIFO.
 * A write is dangerous: Tx events are written to the Message RAM at this unchecked address and length.
 * Contradictions of the manual: bit_tables_missing, overview_page_turned.
 * §2.3.45 Table 46 p.44; Table 1 p.6 (reset and access); §3.5.8 p.78
 */
#define M_CAN_TXEFC_OFFSET 0x0F0U
#define M_CAN_TXEFC_RESET UINT32_C(0x00000000)
#define M_CAN_TXEFC_RESET_MASK UINT32_C(0xFFFFFFFF)
/* EFWM: Fill level of the Tx Event FIFO that sets IR.TEFW, 1 to 32; 0 and more than 32 switch the watermark off.
 * Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means value elements.
 */
#define M_CAN_TXEFC_EFWM_Pos 24U
#define M_CAN_TXEFC_EFWM_Msk UINT32_C(0x3F000000)
#define M_CAN_TXEFC_EFWM_Width 6U
#define M_CAN_TXEFC_EFWM_Access "rw:config"
#define M_CAN_TXEFC_EFWM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TXEFC_EFWM_Pos) & M_CAN_TXEFC_EFWM_Msk))
static inline uint32_t m_can_txefc_efwm_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXEFC_EFWM_Msk) >> M_CAN_TXEFC_EFWM_Pos);
}
static inline uint32_t m_can_txefc_efwm_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 63U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TXEFC_EFWM_Msk) | M_CAN_TXEFC_EFWM_SET(value));
}
/* EFS: Number of elements of the Tx Event FIFO (two words each): 0 for none, 1 to 32; more than 32 counts as 32.
 * Elements count from 0. Access rw:config. A write has an effect only if config (CCCR.INIT && CCCR.CCE). Means
 * value elements.
 */
#define M_CAN_TXEFC_EFS_Pos 16U
#define M_CAN_TXEFC_EFS_Msk UINT32_C(0x003F0000)
#define M_CAN_TXEFC_EFS_Width 6U
#define M_CAN_TXEFC_EFS_Access "rw:config"
#define M_CAN_TXEFC_EFS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TXEFC_EFS_Pos) & M_CAN_TXEFC_EFS_Msk))
static inline uint32_t m_can_txefc_efs_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXEFC_EFS_Msk) >> M_CAN_TXEFC_EFS_Pos);
}
static inline uint32_t m_can_txefc_efs_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 63U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TXEFC_EFS_Msk) | M_CAN_TXEFC_EFS_SET(value));
}
/* EFSA: Start of the Tx Event FIFO in Message RAM, as a 32-bit word address. Access rw:config. A write has an
 * effect only if config (CCCR.INIT && CCCR.CCE). Means value words.
 */
#define M_CAN_TXEFC_EFSA_Pos 2U
#define M_CAN_TXEFC_EFSA_Msk UINT32_C(0x0000FFFC)
#define M_CAN_TXEFC_EFSA_Width 14U
#define M_CAN_TXEFC_EFSA_Access "rw:config"
#define M_CAN_TXEFC_EFSA_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TXEFC_EFSA_Pos) & M_CAN_TXEFC_EFSA_Msk))
static inline uint32_t m_can_txefc_efsa_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXEFC_EFSA_Msk) >> M_CAN_TXEFC_EFSA_Pos);
}
static inline uint32_t m_can_txefc_efsa_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 16383U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TXEFC_EFSA_Msk) | M_CAN_TXEFC_EFSA_SET(value));
}
/* Clears and sets the given bits: one read and one store. Flags and requests that are not among the given bits
 * are left alone.
 */
static inline void m_can_txefc_modify(m_can_regs_t *regs, uint32_t clear, uint32_t set)
{
    uint32_t value = regs->TXEFC;
    regs->TXEFC = (uint32_t)((value & (uint32_t)~clear) | set);
}

/* TXEFS: Tx Event FIFO Status.
 * Indices and fill level of the Tx Event FIFO. Reset when CCCR.CCE is set.
 * Contradictions of the manual: bit_tables_missing, overview_page_turned.
 * §2.3.46 Table 47 p.45; Table 1 p.6 (reset and access); §3.5.8 p.78; §3.1.1 p.57
 */
#define M_CAN_TXEFS_OFFSET 0x0F4U
#define M_CAN_TXEFS_RESET UINT32_C(0x00000000)
#define M_CAN_TXEFS_RESET_MASK UINT32_C(0xFFFFFFFF)
/* TEFL: Copy of IR.TEFL: an event was lost; cleared by clearing IR.TEFL. Access ro.
 * Contradictions of the manual: lost_flags_and_cce.
 */
#define M_CAN_TXEFS_TEFL_Pos 25U
#define M_CAN_TXEFS_TEFL_Msk UINT32_C(0x02000000)
#define M_CAN_TXEFS_TEFL_Width 1U
#define M_CAN_TXEFS_TEFL_Access "ro"
static inline uint32_t m_can_txefs_tefl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXEFS_TEFL_Msk) >> M_CAN_TXEFS_TEFL_Pos);
}
/* EFF: The Tx Event FIFO is full; further events are discarded. Access ro. */
#define M_CAN_TXEFS_EFF_Pos 24U
#define M_CAN_TXEFS_EFF_Msk UINT32_C(0x01000000)
#define M_CAN_TXEFS_EFF_Width 1U
#define M_CAN_TXEFS_EFF_Access "ro"
static inline uint32_t m_can_txefs_eff_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXEFS_EFF_Msk) >> M_CAN_TXEFS_EFF_Pos);
}
/* EFPI: Put index of the Tx Event FIFO, 0 to 31: the element that is written next. Access ro. */
#define M_CAN_TXEFS_EFPI_Pos 16U
#define M_CAN_TXEFS_EFPI_Msk UINT32_C(0x001F0000)
#define M_CAN_TXEFS_EFPI_Width 5U
#define M_CAN_TXEFS_EFPI_Access "ro"
static inline uint32_t m_can_txefs_efpi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXEFS_EFPI_Msk) >> M_CAN_TXEFS_EFPI_Pos);
}
/* EFGI: Get index of the Tx Event FIFO, 0 to 31: the oldest element. Access ro. */
#define M_CAN_TXEFS_EFGI_Pos 8U
#define M_CAN_TXEFS_EFGI_Msk UINT32_C(0x00001F00)
#define M_CAN_TXEFS_EFGI_Width 5U
#define M_CAN_TXEFS_EFGI_Access "ro"
static inline uint32_t m_can_txefs_efgi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXEFS_EFGI_Msk) >> M_CAN_TXEFS_EFGI_Pos);
}
/* EFFL: Number of events in the Tx Event FIFO, 0 to 32. Access ro. Means value elements. */
#define M_CAN_TXEFS_EFFL_Pos 0U
#define M_CAN_TXEFS_EFFL_Msk UINT32_C(0x0000003F)
#define M_CAN_TXEFS_EFFL_Width 6U
#define M_CAN_TXEFS_EFFL_Access "ro"
static inline uint32_t m_can_txefs_effl_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXEFS_EFFL_Msk) >> M_CAN_TXEFS_EFFL_Pos);
}

/* TXEFA: Tx Event FIFO Acknowledge.
 * Releases elements of the Tx Event FIFO that have been read.
 * Hazard: The written index is not checked. A wrong one moves the get index to a wrong place and loses events.
 * Hazard: Every write moves the get index, a written-back copy too. Write only right after reading elements.
 * Contradictions of the manual: bit_tables_missing, overview_page_turned.
 * §2.3.47 Table 48 p.45; Table 1 p.6 (reset and access); §3.6 p.78
 */
#define M_CAN_TXEFA_OFFSET 0x0F8U
#define M_CAN_TXEFA_RESET UINT32_C(0x00000000)
#define M_CAN_TXEFA_RESET_MASK UINT32_C(0xFFFFFFFF)
/* EFAI: Index of the last element read from the Tx Event FIFO. A write sets the get index TXEFS.EFGI to the
 * element behind it and updates the fill level TXEFS.EFFL; one write releases all elements up to this one.
 * Access rwh. Read and write, but hardware changes it too: writing back a stale value undoes the hardware.
 */
#define M_CAN_TXEFA_EFAI_Pos 0U
#define M_CAN_TXEFA_EFAI_Msk UINT32_C(0x0000001F)
#define M_CAN_TXEFA_EFAI_Width 5U
#define M_CAN_TXEFA_EFAI_Access "rwh"
#define M_CAN_TXEFA_EFAI_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TXEFA_EFAI_Pos) & M_CAN_TXEFA_EFAI_Msk))
static inline uint32_t m_can_txefa_efai_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TXEFA_EFAI_Msk) >> M_CAN_TXEFA_EFAI_Pos);
}
static inline uint32_t m_can_txefa_efai_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 31U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TXEFA_EFAI_Msk) | M_CAN_TXEFA_EFAI_SET(value));
}
/* No read-modify-write: no value written to EFAI leaves it alone. Compose the whole value and store it. */

/* RX_BUFFER: Rx Buffer and FIFO Element.
 * A received message, in a dedicated Rx Buffer (debug messages too) or in one of the Rx FIFOs.
 * Byte 0 stands in bits 7:0 of R2, byte 3 in bits 31:24. Bytes of a longer message than the element holds are
 * dropped.
 * §2.4.2 Table 49 p.47
 */
typedef struct {
    volatile uint32_t R0; /* Identifier and frame kind. */
    volatile uint32_t R1A_R1B; /* Filter result, format, length and the internal timestamp. */
    volatile uint32_t PAYLOAD[16];
} m_can_rx_buffer_t;
M_CAN_STATIC_ASSERT(offsetof(m_can_rx_buffer_t, R0) == 0x000U, m_can_rx_buffer_at_R0);
M_CAN_STATIC_ASSERT(offsetof(m_can_rx_buffer_t, R1A_R1B) == 0x004U, m_can_rx_buffer_at_R1A_R1B);
M_CAN_STATIC_ASSERT(offsetof(m_can_rx_buffer_t, PAYLOAD) == 0x008U, m_can_rx_buffer_at_PAYLOAD);
M_CAN_STATIC_ASSERT(sizeof(m_can_rx_buffer_t) == 0x048U, m_can_rx_buffer_size);
#define M_CAN_RX_BUFFER_HEADER_BYTES 8U
/* Word R0 of RX_BUFFER: Identifier and frame kind.
 * §2.4.2 Table 49 p.47
 */
#define M_CAN_RX_BUFFER_R0_OFFSET 0x000U
/* ESI: Error state indicator of the frame: error state of its transmitter. Access rw. */
#define M_CAN_RX_BUFFER_R0_ESI_Pos 31U
#define M_CAN_RX_BUFFER_R0_ESI_Msk UINT32_C(0x80000000)
#define M_CAN_RX_BUFFER_R0_ESI_Width 1U
#define M_CAN_RX_BUFFER_R0_ESI_Access "rw"
#define M_CAN_RX_BUFFER_R0_ESI_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R0_ESI_Pos) & M_CAN_RX_BUFFER_R0_ESI_Msk))
static inline uint32_t m_can_rx_buffer_r0_esi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R0_ESI_Msk) >> M_CAN_RX_BUFFER_R0_ESI_Pos);
}
static inline uint32_t m_can_rx_buffer_r0_esi_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R0_ESI_Msk) | M_CAN_RX_BUFFER_R0_ESI_SET(value));
}
/* XTD: Length of the identifier. Access rw. */
#define M_CAN_RX_BUFFER_R0_XTD_Pos 30U
#define M_CAN_RX_BUFFER_R0_XTD_Msk UINT32_C(0x40000000)
#define M_CAN_RX_BUFFER_R0_XTD_Width 1U
#define M_CAN_RX_BUFFER_R0_XTD_Access "rw"
#define M_CAN_RX_BUFFER_R0_XTD_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R0_XTD_Pos) & M_CAN_RX_BUFFER_R0_XTD_Msk))
static inline uint32_t m_can_rx_buffer_r0_xtd_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R0_XTD_Msk) >> M_CAN_RX_BUFFER_R0_XTD_Pos);
}
static inline uint32_t m_can_rx_buffer_r0_xtd_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R0_XTD_Msk) | M_CAN_RX_BUFFER_R0_XTD_SET(value));
}
/* RTR: Data or remote frame. CAN FD has no remote frames; the dominant RRS bit stands in this place. Access rw.
 * §2.4.2 p.47; §2.4.2 p.48
 */
#define M_CAN_RX_BUFFER_R0_RTR_Pos 29U
#define M_CAN_RX_BUFFER_R0_RTR_Msk UINT32_C(0x20000000)
#define M_CAN_RX_BUFFER_R0_RTR_Width 1U
#define M_CAN_RX_BUFFER_R0_RTR_Access "rw"
#define M_CAN_RX_BUFFER_R0_RTR_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R0_RTR_Pos) & M_CAN_RX_BUFFER_R0_RTR_Msk))
static inline uint32_t m_can_rx_buffer_r0_rtr_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R0_RTR_Msk) >> M_CAN_RX_BUFFER_R0_RTR_Pos);
}
static inline uint32_t m_can_rx_buffer_r0_rtr_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R0_RTR_Msk) | M_CAN_RX_BUFFER_R0_RTR_SET(value));
}
/* ID: Identifier, unmasked. A standard identifier stands in bits 28:18. Access rw.
 * §2.4.2 p.48
 */
#define M_CAN_RX_BUFFER_R0_ID_Pos 0U
#define M_CAN_RX_BUFFER_R0_ID_Msk UINT32_C(0x1FFFFFFF)
#define M_CAN_RX_BUFFER_R0_ID_Width 29U
#define M_CAN_RX_BUFFER_R0_ID_Access "rw"
#define M_CAN_RX_BUFFER_R0_ID_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R0_ID_Pos) & M_CAN_RX_BUFFER_R0_ID_Msk))
static inline uint32_t m_can_rx_buffer_r0_id_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R0_ID_Msk) >> M_CAN_RX_BUFFER_R0_ID_Pos);
}
static inline uint32_t m_can_rx_buffer_r0_id_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= UINT32_C(536870911));
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R0_ID_Msk) | M_CAN_RX_BUFFER_R0_ID_SET(value));
}
/* Word R1A of RX_BUFFER: Filter result, format, length and the internal timestamp.
 * Has this layout only if !CCCR.UTSU.
 * §2.4.2 p.48
 */
#define M_CAN_RX_BUFFER_R1A_OFFSET 0x004U
/* ANMF: The message matched no filter element and was accepted through GFC.ANFS or GFC.ANFE. Access rw. */
#define M_CAN_RX_BUFFER_R1A_ANMF_Pos 31U
#define M_CAN_RX_BUFFER_R1A_ANMF_Msk UINT32_C(0x80000000)
#define M_CAN_RX_BUFFER_R1A_ANMF_Width 1U
#define M_CAN_RX_BUFFER_R1A_ANMF_Access "rw"
#define M_CAN_RX_BUFFER_R1A_ANMF_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1A_ANMF_Pos) & M_CAN_RX_BUFFER_R1A_ANMF_Msk))
static inline uint32_t m_can_rx_buffer_r1a_anmf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1A_ANMF_Msk) >> M_CAN_RX_BUFFER_R1A_ANMF_Pos);
}
static inline uint32_t m_can_rx_buffer_r1a_anmf_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1A_ANMF_Msk) | M_CAN_RX_BUFFER_R1A_ANMF_SET(value));
}
/* FIDX: Index of the matching filter element, from 0 to the list size minus 1; invalid if ANMF is set. Access
 * rw.
 */
#define M_CAN_RX_BUFFER_R1A_FIDX_Pos 24U
#define M_CAN_RX_BUFFER_R1A_FIDX_Msk UINT32_C(0x7F000000)
#define M_CAN_RX_BUFFER_R1A_FIDX_Width 7U
#define M_CAN_RX_BUFFER_R1A_FIDX_Access "rw"
#define M_CAN_RX_BUFFER_R1A_FIDX_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1A_FIDX_Pos) & M_CAN_RX_BUFFER_R1A_FIDX_Msk))
static inline uint32_t m_can_rx_buffer_r1a_fidx_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1A_FIDX_Msk) >> M_CAN_RX_BUFFER_R1A_FIDX_Pos);
}
static inline uint32_t m_can_rx_buffer_r1a_fidx_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 127U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1A_FIDX_Msk) | M_CAN_RX_BUFFER_R1A_FIDX_SET(value));
}
/* FDF: Format of the frame. Access rw. */
#define M_CAN_RX_BUFFER_R1A_FDF_Pos 21U
#define M_CAN_RX_BUFFER_R1A_FDF_Msk UINT32_C(0x00200000)
#define M_CAN_RX_BUFFER_R1A_FDF_Width 1U
#define M_CAN_RX_BUFFER_R1A_FDF_Access "rw"
#define M_CAN_RX_BUFFER_R1A_FDF_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1A_FDF_Pos) & M_CAN_RX_BUFFER_R1A_FDF_Msk))
static inline uint32_t m_can_rx_buffer_r1a_fdf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1A_FDF_Msk) >> M_CAN_RX_BUFFER_R1A_FDF_Pos);
}
static inline uint32_t m_can_rx_buffer_r1a_fdf_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1A_FDF_Msk) | M_CAN_RX_BUFFER_R1A_FDF_SET(value));
}
/* BRS: The frame switched the bit rate. Access rw. */
#define M_CAN_RX_BUFFER_R1A_BRS_Pos 20U
#define M_CAN_RX_BUFFER_R1A_BRS_Msk UINT32_C(0x00100000)
#define M_CAN_RX_BUFFER_R1A_BRS_Width 1U
#define M_CAN_RX_BUFFER_R1A_BRS_Access "rw"
#define M_CAN_RX_BUFFER_R1A_BRS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1A_BRS_Pos) & M_CAN_RX_BUFFER_R1A_BRS_Msk))
static inline uint32_t m_can_rx_buffer_r1a_brs_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1A_BRS_Msk) >> M_CAN_RX_BUFFER_R1A_BRS_Pos);
}
static inline uint32_t m_can_rx_buffer_r1a_brs_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1A_BRS_Msk) | M_CAN_RX_BUFFER_R1A_BRS_SET(value));
}
/* DLC: Data length code. Access rw. */
#define M_CAN_RX_BUFFER_R1A_DLC_Pos 16U
#define M_CAN_RX_BUFFER_R1A_DLC_Msk UINT32_C(0x000F0000)
#define M_CAN_RX_BUFFER_R1A_DLC_Width 4U
#define M_CAN_RX_BUFFER_R1A_DLC_Access "rw"
#define M_CAN_RX_BUFFER_R1A_DLC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1A_DLC_Pos) & M_CAN_RX_BUFFER_R1A_DLC_Msk))
static inline uint32_t m_can_rx_buffer_r1a_dlc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1A_DLC_Msk) >> M_CAN_RX_BUFFER_R1A_DLC_Pos);
}
static inline uint32_t m_can_rx_buffer_r1a_dlc_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1A_DLC_Msk) | M_CAN_RX_BUFFER_R1A_DLC_SET(value));
}
/* RXTS: Timestamp captured at the start of the frame, in the unit set by TSCC.TCP. Access rw. */
#define M_CAN_RX_BUFFER_R1A_RXTS_Pos 0U
#define M_CAN_RX_BUFFER_R1A_RXTS_Msk UINT32_C(0x0000FFFF)
#define M_CAN_RX_BUFFER_R1A_RXTS_Width 16U
#define M_CAN_RX_BUFFER_R1A_RXTS_Access "rw"
#define M_CAN_RX_BUFFER_R1A_RXTS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1A_RXTS_Pos) & M_CAN_RX_BUFFER_R1A_RXTS_Msk))
static inline uint32_t m_can_rx_buffer_r1a_rxts_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1A_RXTS_Msk) >> M_CAN_RX_BUFFER_R1A_RXTS_Pos);
}
static inline uint32_t m_can_rx_buffer_r1a_rxts_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 65535U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1A_RXTS_Msk) | M_CAN_RX_BUFFER_R1A_RXTS_SET(value));
}
/* Word R1B of RX_BUFFER: Filter result, format, length and a reference to a timestamp of the TSU.
 * Has this layout only if CCCR.UTSU.
 * §2.4.2 p.48
 */
#define M_CAN_RX_BUFFER_R1B_OFFSET 0x004U
/* ANMF: The message matched no filter element and was accepted through GFC.ANFS or GFC.ANFE. Access rw. */
#define M_CAN_RX_BUFFER_R1B_ANMF_Pos 31U
#define M_CAN_RX_BUFFER_R1B_ANMF_Msk UINT32_C(0x80000000)
#define M_CAN_RX_BUFFER_R1B_ANMF_Width 1U
#define M_CAN_RX_BUFFER_R1B_ANMF_Access "rw"
#define M_CAN_RX_BUFFER_R1B_ANMF_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1B_ANMF_Pos) & M_CAN_RX_BUFFER_R1B_ANMF_Msk))
static inline uint32_t m_can_rx_buffer_r1b_anmf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1B_ANMF_Msk) >> M_CAN_RX_BUFFER_R1B_ANMF_Pos);
}
static inline uint32_t m_can_rx_buffer_r1b_anmf_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1B_ANMF_Msk) | M_CAN_RX_BUFFER_R1B_ANMF_SET(value));
}
/* FIDX: Index of the matching filter element, from 0 to the list size minus 1; invalid if ANMF is set. Access
 * rw.
 */
#define M_CAN_RX_BUFFER_R1B_FIDX_Pos 24U
#define M_CAN_RX_BUFFER_R1B_FIDX_Msk UINT32_C(0x7F000000)
#define M_CAN_RX_BUFFER_R1B_FIDX_Width 7U
#define M_CAN_RX_BUFFER_R1B_FIDX_Access "rw"
#define M_CAN_RX_BUFFER_R1B_FIDX_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1B_FIDX_Pos) & M_CAN_RX_BUFFER_R1B_FIDX_Msk))
static inline uint32_t m_can_rx_buffer_r1b_fidx_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1B_FIDX_Msk) >> M_CAN_RX_BUFFER_R1B_FIDX_Pos);
}
static inline uint32_t m_can_rx_buffer_r1b_fidx_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 127U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1B_FIDX_Msk) | M_CAN_RX_BUFFER_R1B_FIDX_SET(value));
}
/* FDF: Format of the frame. Access rw. */
#define M_CAN_RX_BUFFER_R1B_FDF_Pos 21U
#define M_CAN_RX_BUFFER_R1B_FDF_Msk UINT32_C(0x00200000)
#define M_CAN_RX_BUFFER_R1B_FDF_Width 1U
#define M_CAN_RX_BUFFER_R1B_FDF_Access "rw"
#define M_CAN_RX_BUFFER_R1B_FDF_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1B_FDF_Pos) & M_CAN_RX_BUFFER_R1B_FDF_Msk))
static inline uint32_t m_can_rx_buffer_r1b_fdf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1B_FDF_Msk) >> M_CAN_RX_BUFFER_R1B_FDF_Pos);
}
static inline uint32_t m_can_rx_buffer_r1b_fdf_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1B_FDF_Msk) | M_CAN_RX_BUFFER_R1B_FDF_SET(value));
}
/* BRS: The frame switched the bit rate. Access rw. */
#define M_CAN_RX_BUFFER_R1B_BRS_Pos 20U
#define M_CAN_RX_BUFFER_R1B_BRS_Msk UINT32_C(0x00100000)
#define M_CAN_RX_BUFFER_R1B_BRS_Width 1U
#define M_CAN_RX_BUFFER_R1B_BRS_Access "rw"
#define M_CAN_RX_BUFFER_R1B_BRS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1B_BRS_Pos) & M_CAN_RX_BUFFER_R1B_BRS_Msk))
static inline uint32_t m_can_rx_buffer_r1b_brs_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1B_BRS_Msk) >> M_CAN_RX_BUFFER_R1B_BRS_Pos);
}
static inline uint32_t m_can_rx_buffer_r1b_brs_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1B_BRS_Msk) | M_CAN_RX_BUFFER_R1B_BRS_SET(value));
}
/* DLC: Data length code. Access rw. */
#define M_CAN_RX_BUFFER_R1B_DLC_Pos 16U
#define M_CAN_RX_BUFFER_R1B_DLC_Msk UINT32_C(0x000F0000)
#define M_CAN_RX_BUFFER_R1B_DLC_Width 4U
#define M_CAN_RX_BUFFER_R1B_DLC_Access "rw"
#define M_CAN_RX_BUFFER_R1B_DLC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1B_DLC_Pos) & M_CAN_RX_BUFFER_R1B_DLC_Msk))
static inline uint32_t m_can_rx_buffer_r1b_dlc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1B_DLC_Msk) >> M_CAN_RX_BUFFER_R1B_DLC_Pos);
}
static inline uint32_t m_can_rx_buffer_r1b_dlc_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1B_DLC_Msk) | M_CAN_RX_BUFFER_R1B_DLC_SET(value));
}
/* TSC: The TSU captured a timestamp at the end of the frame, because the matching filter element has SSYNC or
 * ESYNC set; RXTSP is valid. Access rw.
 * §2.4.2 p.47; §2.4.2 p.48; §3.2.2 p.64
 */
#define M_CAN_RX_BUFFER_R1B_TSC_Pos 4U
#define M_CAN_RX_BUFFER_R1B_TSC_Msk UINT32_C(0x00000010)
#define M_CAN_RX_BUFFER_R1B_TSC_Width 1U
#define M_CAN_RX_BUFFER_R1B_TSC_Access "rw"
#define M_CAN_RX_BUFFER_R1B_TSC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1B_TSC_Pos) & M_CAN_RX_BUFFER_R1B_TSC_Msk))
static inline uint32_t m_can_rx_buffer_r1b_tsc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1B_TSC_Msk) >> M_CAN_RX_BUFFER_R1B_TSC_Pos);
}
static inline uint32_t m_can_rx_buffer_r1b_tsc_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1B_TSC_Msk) | M_CAN_RX_BUFFER_R1B_TSC_SET(value));
}
/* RXTSP: Number of the TSU timestamp register that holds the timestamp. Access rw. */
#define M_CAN_RX_BUFFER_R1B_RXTSP_Pos 0U
#define M_CAN_RX_BUFFER_R1B_RXTSP_Msk UINT32_C(0x0000000F)
#define M_CAN_RX_BUFFER_R1B_RXTSP_Width 4U
#define M_CAN_RX_BUFFER_R1B_RXTSP_Access "rw"
#define M_CAN_RX_BUFFER_R1B_RXTSP_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_RX_BUFFER_R1B_RXTSP_Pos) & M_CAN_RX_BUFFER_R1B_RXTSP_Msk))
static inline uint32_t m_can_rx_buffer_r1b_rxtsp_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_RX_BUFFER_R1B_RXTSP_Msk) >> M_CAN_RX_BUFFER_R1B_RXTSP_Pos);
}
static inline uint32_t m_can_rx_buffer_r1b_rxtsp_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_RX_BUFFER_R1B_RXTSP_Msk) | M_CAN_RX_BUFFER_R1B_RXTSP_SET(value));
}
#define M_CAN_RX_BUFFER_PAYLOAD_MAX 64U
/* Bytes of an element that is configured for a payload of so many bytes. */
#define M_CAN_RX_BUFFER_BYTES(payload) (8U + (payload))
/* Payload in bytes for a code of the size field; 0 for a code that has none. */
static inline unsigned int m_can_rx_buffer_payload_bytes(unsigned int code)
{
    switch (code) {
    case 0U: return 8U;
    case 1U: return 12U;
    case 2U: return 16U;
    case 3U: return 20U;
    case 4U: return 24U;
    case 5U: return 32U;
    case 6U: return 48U;
    case 7U: return 64U;
    default: return 0U;
    }
}
/* Reads the first bytes of the payload, every word once; byte 0 is the lowest of the first word. */
static inline void m_can_rx_buffer_read_payload(const m_can_rx_buffer_t *element, uint8_t *data, size_t count)
{
    M_CAN_ASSERT(count <= 64U);
    for (size_t at = 0; at < count; at += 4U) {
        const uint32_t word = element->PAYLOAD[at / 4U];
        for (size_t byte = 0; byte < 4U && at + byte < count; ++byte) {
            data[at + byte] = (uint8_t)((word >> (8U * byte)) & 0xFFU);
        }
    }
}
/* Writes the first bytes of the payload, every word once; the rest of the last word becomes 0. */
static inline void m_can_rx_buffer_write_payload(m_can_rx_buffer_t *element, const uint8_t *data, size_t count)
{
    M_CAN_ASSERT(count <= 64U);
    for (size_t at = 0; at < count; at += 4U) {
        uint32_t word = 0;
        for (size_t byte = 0; byte < 4U && at + byte < count; ++byte) {
            word = (uint32_t)(word | (uint32_t)((uint32_t)data[at + byte] << (8U * byte)));
        }
        element->PAYLOAD[at / 4U] = word;
    }
}

/* TX_BUFFER: Tx Buffer Element.
 * A message to send, in a dedicated Tx Buffer, the Tx FIFO or the Tx Queue.
 * Byte 0 stands in bits 7:0 of T2, byte 3 in bits 31:24.
 * §2.4.3 Table 50 p.49
 */
typedef struct {
    volatile uint32_t T0; /* Identifier and frame kind. */
    volatile uint32_t T1; /* Message Marker, format and length. */
    volatile uint32_t PAYLOAD[16];
} m_can_tx_buffer_t;
M_CAN_STATIC_ASSERT(offsetof(m_can_tx_buffer_t, T0) == 0x000U, m_can_tx_buffer_at_T0);
M_CAN_STATIC_ASSERT(offsetof(m_can_tx_buffer_t, T1) == 0x004U, m_can_tx_buffer_at_T1);
M_CAN_STATIC_ASSERT(offsetof(m_can_tx_buffer_t, PAYLOAD) == 0x008U, m_can_tx_buffer_at_PAYLOAD);
M_CAN_STATIC_ASSERT(sizeof(m_can_tx_buffer_t) == 0x048U, m_can_tx_buffer_size);
#define M_CAN_TX_BUFFER_HEADER_BYTES 8U
/* Word T0 of TX_BUFFER: Identifier and frame kind.
 * §2.4.3 Table 50 p.49
 */
#define M_CAN_TX_BUFFER_T0_OFFSET 0x000U
/* ESI: Error state indicator of a CAN FD frame; ORed with the node's error passive state. Used only if CCCR.FDOE
 * is 1. Access rw.
 */
#define M_CAN_TX_BUFFER_T0_ESI_Pos 31U
#define M_CAN_TX_BUFFER_T0_ESI_Msk UINT32_C(0x80000000)
#define M_CAN_TX_BUFFER_T0_ESI_Width 1U
#define M_CAN_TX_BUFFER_T0_ESI_Access "rw"
#define M_CAN_TX_BUFFER_T0_ESI_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_BUFFER_T0_ESI_Pos) & M_CAN_TX_BUFFER_T0_ESI_Msk))
static inline uint32_t m_can_tx_buffer_t0_esi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_BUFFER_T0_ESI_Msk) >> M_CAN_TX_BUFFER_T0_ESI_Pos);
}
static inline uint32_t m_can_tx_buffer_t0_esi_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_BUFFER_T0_ESI_Msk) | M_CAN_TX_BUFFER_T0_ESI_SET(value));
}
/* XTD: Length of the identifier. Access rw. */
#define M_CAN_TX_BUFFER_T0_XTD_Pos 30U
#define M_CAN_TX_BUFFER_T0_XTD_Msk UINT32_C(0x40000000)
#define M_CAN_TX_BUFFER_T0_XTD_Width 1U
#define M_CAN_TX_BUFFER_T0_XTD_Access "rw"
#define M_CAN_TX_BUFFER_T0_XTD_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_BUFFER_T0_XTD_Pos) & M_CAN_TX_BUFFER_T0_XTD_Msk))
static inline uint32_t m_can_tx_buffer_t0_xtd_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_BUFFER_T0_XTD_Msk) >> M_CAN_TX_BUFFER_T0_XTD_Pos);
}
static inline uint32_t m_can_tx_buffer_t0_xtd_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_BUFFER_T0_XTD_Msk) | M_CAN_TX_BUFFER_T0_XTD_SET(value));
}
/* RTR: Data or remote frame. A remote frame is sent in Classical CAN format even if CAN FD is enabled. Access
 * rw.
 * §2.4.3 p.49; §2.4.3 p.50
 */
#define M_CAN_TX_BUFFER_T0_RTR_Pos 29U
#define M_CAN_TX_BUFFER_T0_RTR_Msk UINT32_C(0x20000000)
#define M_CAN_TX_BUFFER_T0_RTR_Width 1U
#define M_CAN_TX_BUFFER_T0_RTR_Access "rw"
#define M_CAN_TX_BUFFER_T0_RTR_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_BUFFER_T0_RTR_Pos) & M_CAN_TX_BUFFER_T0_RTR_Msk))
static inline uint32_t m_can_tx_buffer_t0_rtr_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_BUFFER_T0_RTR_Msk) >> M_CAN_TX_BUFFER_T0_RTR_Pos);
}
static inline uint32_t m_can_tx_buffer_t0_rtr_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_BUFFER_T0_RTR_Msk) | M_CAN_TX_BUFFER_T0_RTR_SET(value));
}
/* ID: Identifier. A standard identifier belongs in bits 28:18. Access rw.
 * §2.4.3 p.50
 */
#define M_CAN_TX_BUFFER_T0_ID_Pos 0U
#define M_CAN_TX_BUFFER_T0_ID_Msk UINT32_C(0x1FFFFFFF)
#define M_CAN_TX_BUFFER_T0_ID_Width 29U
#define M_CAN_TX_BUFFER_T0_ID_Access "rw"
#define M_CAN_TX_BUFFER_T0_ID_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_BUFFER_T0_ID_Pos) & M_CAN_TX_BUFFER_T0_ID_Msk))
static inline uint32_t m_can_tx_buffer_t0_id_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_BUFFER_T0_ID_Msk) >> M_CAN_TX_BUFFER_T0_ID_Pos);
}
static inline uint32_t m_can_tx_buffer_t0_id_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= UINT32_C(536870911));
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_BUFFER_T0_ID_Msk) | M_CAN_TX_BUFFER_T0_ID_SET(value));
}
/* Word T1 of TX_BUFFER: Message Marker, format and length.
 * §2.4.3 p.50
 */
#define M_CAN_TX_BUFFER_T1_OFFSET 0x004U
/* MM[7:0]: Low byte of the Message Marker, copied to the Tx event of this message. Access rw. */
#define M_CAN_TX_BUFFER_T1_MM_Pos 24U
#define M_CAN_TX_BUFFER_T1_MM_Msk UINT32_C(0xFF000000)
#define M_CAN_TX_BUFFER_T1_MM_Width 8U
#define M_CAN_TX_BUFFER_T1_MM_Access "rw"
#define M_CAN_TX_BUFFER_T1_MM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_BUFFER_T1_MM_Pos) & M_CAN_TX_BUFFER_T1_MM_Msk))
static inline uint32_t m_can_tx_buffer_t1_mm_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_BUFFER_T1_MM_Msk) >> M_CAN_TX_BUFFER_T1_MM_Pos);
}
static inline uint32_t m_can_tx_buffer_t1_mm_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 255U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_BUFFER_T1_MM_Msk) | M_CAN_TX_BUFFER_T1_MM_SET(value));
}
/* EFC: Stores a Tx event when the message has been sent. Access rw. */
#define M_CAN_TX_BUFFER_T1_EFC_Pos 23U
#define M_CAN_TX_BUFFER_T1_EFC_Msk UINT32_C(0x00800000)
#define M_CAN_TX_BUFFER_T1_EFC_Width 1U
#define M_CAN_TX_BUFFER_T1_EFC_Access "rw"
#define M_CAN_TX_BUFFER_T1_EFC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_BUFFER_T1_EFC_Pos) & M_CAN_TX_BUFFER_T1_EFC_Msk))
static inline uint32_t m_can_tx_buffer_t1_efc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_BUFFER_T1_EFC_Msk) >> M_CAN_TX_BUFFER_T1_EFC_Pos);
}
static inline uint32_t m_can_tx_buffer_t1_efc_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_BUFFER_T1_EFC_Msk) | M_CAN_TX_BUFFER_T1_EFC_SET(value));
}
/* TSCE: Has the TSU capture a timestamp of this message. Only with CCCR.UTSU set. Access rw. */
#define M_CAN_TX_BUFFER_T1_TSCE_Pos 22U
#define M_CAN_TX_BUFFER_T1_TSCE_Msk UINT32_C(0x00400000)
#define M_CAN_TX_BUFFER_T1_TSCE_Width 1U
#define M_CAN_TX_BUFFER_T1_TSCE_Access "rw"
#define M_CAN_TX_BUFFER_T1_TSCE_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_BUFFER_T1_TSCE_Pos) & M_CAN_TX_BUFFER_T1_TSCE_Msk))
static inline uint32_t m_can_tx_buffer_t1_tsce_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_BUFFER_T1_TSCE_Msk) >> M_CAN_TX_BUFFER_T1_TSCE_Pos);
}
static inline uint32_t m_can_tx_buffer_t1_tsce_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_BUFFER_T1_TSCE_Msk) | M_CAN_TX_BUFFER_T1_TSCE_SET(value));
}
/* FDF: Format of the frame. Used only if CCCR.FDOE is 1, else the frame is classic. Access rw. */
#define M_CAN_TX_BUFFER_T1_FDF_Pos 21U
#define M_CAN_TX_BUFFER_T1_FDF_Msk UINT32_C(0x00200000)
#define M_CAN_TX_BUFFER_T1_FDF_Width 1U
#define M_CAN_TX_BUFFER_T1_FDF_Access "rw"
#define M_CAN_TX_BUFFER_T1_FDF_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_BUFFER_T1_FDF_Pos) & M_CAN_TX_BUFFER_T1_FDF_Msk))
static inline uint32_t m_can_tx_buffer_t1_fdf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_BUFFER_T1_FDF_Msk) >> M_CAN_TX_BUFFER_T1_FDF_Pos);
}
static inline uint32_t m_can_tx_buffer_t1_fdf_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_BUFFER_T1_FDF_Msk) | M_CAN_TX_BUFFER_T1_FDF_SET(value));
}
/* BRS: Switches the bit rate in a CAN FD frame. Used only if CCCR.FDOE and CCCR.BRSE are 1. Access rw. */
#define M_CAN_TX_BUFFER_T1_BRS_Pos 20U
#define M_CAN_TX_BUFFER_T1_BRS_Msk UINT32_C(0x00100000)
#define M_CAN_TX_BUFFER_T1_BRS_Width 1U
#define M_CAN_TX_BUFFER_T1_BRS_Access "rw"
#define M_CAN_TX_BUFFER_T1_BRS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_BUFFER_T1_BRS_Pos) & M_CAN_TX_BUFFER_T1_BRS_Msk))
static inline uint32_t m_can_tx_buffer_t1_brs_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_BUFFER_T1_BRS_Msk) >> M_CAN_TX_BUFFER_T1_BRS_Pos);
}
static inline uint32_t m_can_tx_buffer_t1_brs_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_BUFFER_T1_BRS_Msk) | M_CAN_TX_BUFFER_T1_BRS_SET(value));
}
/* DLC: Data length code. Bytes beyond the data field of the element are sent as 0xCC. Access rw. */
#define M_CAN_TX_BUFFER_T1_DLC_Pos 16U
#define M_CAN_TX_BUFFER_T1_DLC_Msk UINT32_C(0x000F0000)
#define M_CAN_TX_BUFFER_T1_DLC_Width 4U
#define M_CAN_TX_BUFFER_T1_DLC_Access "rw"
#define M_CAN_TX_BUFFER_T1_DLC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_BUFFER_T1_DLC_Pos) & M_CAN_TX_BUFFER_T1_DLC_Msk))
static inline uint32_t m_can_tx_buffer_t1_dlc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_BUFFER_T1_DLC_Msk) >> M_CAN_TX_BUFFER_T1_DLC_Pos);
}
static inline uint32_t m_can_tx_buffer_t1_dlc_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_BUFFER_T1_DLC_Msk) | M_CAN_TX_BUFFER_T1_DLC_SET(value));
}
/* MM[15:8]: High byte of a wide Message Marker, copied to the Tx event. Only with CCCR.WMM or CCCR.UTSU set.
 * Access rw.
 */
#define M_CAN_TX_BUFFER_T1_MM_HIGH_Pos 8U
#define M_CAN_TX_BUFFER_T1_MM_HIGH_Msk UINT32_C(0x0000FF00)
#define M_CAN_TX_BUFFER_T1_MM_HIGH_Width 8U
#define M_CAN_TX_BUFFER_T1_MM_HIGH_Access "rw"
#define M_CAN_TX_BUFFER_T1_MM_HIGH_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_BUFFER_T1_MM_HIGH_Pos) & M_CAN_TX_BUFFER_T1_MM_HIGH_Msk))
static inline uint32_t m_can_tx_buffer_t1_mm_high_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_BUFFER_T1_MM_HIGH_Msk) >> M_CAN_TX_BUFFER_T1_MM_HIGH_Pos);
}
static inline uint32_t m_can_tx_buffer_t1_mm_high_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 255U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_BUFFER_T1_MM_HIGH_Msk) | M_CAN_TX_BUFFER_T1_MM_HIGH_SET(value));
}
#define M_CAN_TX_BUFFER_PAYLOAD_MAX 64U
/* Bytes of an element that is configured for a payload of so many bytes. */
#define M_CAN_TX_BUFFER_BYTES(payload) (8U + (payload))
/* Payload in bytes for a code of the size field; 0 for a code that has none. */
static inline unsigned int m_can_tx_buffer_payload_bytes(unsigned int code)
{
    switch (code) {
    case 0U: return 8U;
    case 1U: return 12U;
    case 2U: return 16U;
    case 3U: return 20U;
    case 4U: return 24U;
    case 5U: return 32U;
    case 6U: return 48U;
    case 7U: return 64U;
    default: return 0U;
    }
}
/* Reads the first bytes of the payload, every word once; byte 0 is the lowest of the first word. */
static inline void m_can_tx_buffer_read_payload(const m_can_tx_buffer_t *element, uint8_t *data, size_t count)
{
    M_CAN_ASSERT(count <= 64U);
    for (size_t at = 0; at < count; at += 4U) {
        const uint32_t word = element->PAYLOAD[at / 4U];
        for (size_t byte = 0; byte < 4U && at + byte < count; ++byte) {
            data[at + byte] = (uint8_t)((word >> (8U * byte)) & 0xFFU);
        }
    }
}
/* Writes the first bytes of the payload, every word once; the rest of the last word becomes 0. */
static inline void m_can_tx_buffer_write_payload(m_can_tx_buffer_t *element, const uint8_t *data, size_t count)
{
    M_CAN_ASSERT(count <= 64U);
    for (size_t at = 0; at < count; at += 4U) {
        uint32_t word = 0;
        for (size_t byte = 0; byte < 4U && at + byte < count; ++byte) {
            word = (uint32_t)(word | (uint32_t)((uint32_t)data[at + byte] << (8U * byte)));
        }
        element->PAYLOAD[at / 4U] = word;
    }
}
/* MESSAGE_MARKER: 16-bit wide Message Marker; the high byte counts only with CCCR.WMM or CCCR.UTSU set.
 * §2.4.3 p.50
 */
static inline uint32_t m_can_tx_buffer_message_marker_read(const m_can_tx_buffer_t *element)
{
    const uint32_t part0 = element->T1;
    return ((uint32_t)((part0 & UINT32_C(0xFF000000)) >> 24U) << 0U) | ((uint32_t)((part0 & UINT32_C(0x0000FF00)) >> 8U) << 8U);
}
static inline void m_can_tx_buffer_message_marker_write(m_can_tx_buffer_t *element, uint32_t value)
{
    element->T1 = (uint32_t)((element->T1 & (uint32_t)~UINT32_C(0xFF00FF00)) | (uint32_t)(((uint32_t)(value >> 0U) << 24U) & UINT32_C(0xFF000000)) | (uint32_t)(((uint32_t)(value >> 8U) << 8U) & UINT32_C(0x0000FF00)));
}

/* TX_EVENT: Tx Event FIFO Element.
 * Report of a transmitted message. Elements stand in the order in which the messages were sent.
 * §2.4.4 Table 51 p.51
 */
typedef struct {
    volatile uint32_t E0; /* Identifier and frame kind of the transmitted message. */
    volatile uint32_t E1A_E1B; /* 8-bit Message Marker, event type, format, length and the internal timestamp. */
} m_can_tx_event_t;
M_CAN_STATIC_ASSERT(offsetof(m_can_tx_event_t, E0) == 0x000U, m_can_tx_event_at_E0);
M_CAN_STATIC_ASSERT(offsetof(m_can_tx_event_t, E1A_E1B) == 0x004U, m_can_tx_event_at_E1A_E1B);
M_CAN_STATIC_ASSERT(sizeof(m_can_tx_event_t) == 0x008U, m_can_tx_event_size);
#define M_CAN_TX_EVENT_HEADER_BYTES 8U
/* Word E0 of TX_EVENT: Identifier and frame kind of the transmitted message.
 * §2.4.4 Table 51 p.51
 */
#define M_CAN_TX_EVENT_E0_OFFSET 0x000U
/* ESI: Error state indicator of the frame: error state of the node that sent it, which is this one. Access rw. */
#define M_CAN_TX_EVENT_E0_ESI_Pos 31U
#define M_CAN_TX_EVENT_E0_ESI_Msk UINT32_C(0x80000000)
#define M_CAN_TX_EVENT_E0_ESI_Width 1U
#define M_CAN_TX_EVENT_E0_ESI_Access "rw"
#define M_CAN_TX_EVENT_E0_ESI_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E0_ESI_Pos) & M_CAN_TX_EVENT_E0_ESI_Msk))
static inline uint32_t m_can_tx_event_e0_esi_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E0_ESI_Msk) >> M_CAN_TX_EVENT_E0_ESI_Pos);
}
static inline uint32_t m_can_tx_event_e0_esi_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E0_ESI_Msk) | M_CAN_TX_EVENT_E0_ESI_SET(value));
}
/* XTD: Length of the identifier. Access rw. */
#define M_CAN_TX_EVENT_E0_XTD_Pos 30U
#define M_CAN_TX_EVENT_E0_XTD_Msk UINT32_C(0x40000000)
#define M_CAN_TX_EVENT_E0_XTD_Width 1U
#define M_CAN_TX_EVENT_E0_XTD_Access "rw"
#define M_CAN_TX_EVENT_E0_XTD_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E0_XTD_Pos) & M_CAN_TX_EVENT_E0_XTD_Msk))
static inline uint32_t m_can_tx_event_e0_xtd_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E0_XTD_Msk) >> M_CAN_TX_EVENT_E0_XTD_Pos);
}
static inline uint32_t m_can_tx_event_e0_xtd_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E0_XTD_Msk) | M_CAN_TX_EVENT_E0_XTD_SET(value));
}
/* RTR: Data or remote frame. Access rw. */
#define M_CAN_TX_EVENT_E0_RTR_Pos 29U
#define M_CAN_TX_EVENT_E0_RTR_Msk UINT32_C(0x20000000)
#define M_CAN_TX_EVENT_E0_RTR_Width 1U
#define M_CAN_TX_EVENT_E0_RTR_Access "rw"
#define M_CAN_TX_EVENT_E0_RTR_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E0_RTR_Pos) & M_CAN_TX_EVENT_E0_RTR_Msk))
static inline uint32_t m_can_tx_event_e0_rtr_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E0_RTR_Msk) >> M_CAN_TX_EVENT_E0_RTR_Pos);
}
static inline uint32_t m_can_tx_event_e0_rtr_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E0_RTR_Msk) | M_CAN_TX_EVENT_E0_RTR_SET(value));
}
/* ID: Identifier. A standard identifier stands in bits 28:18. Access rw. */
#define M_CAN_TX_EVENT_E0_ID_Pos 0U
#define M_CAN_TX_EVENT_E0_ID_Msk UINT32_C(0x1FFFFFFF)
#define M_CAN_TX_EVENT_E0_ID_Width 29U
#define M_CAN_TX_EVENT_E0_ID_Access "rw"
#define M_CAN_TX_EVENT_E0_ID_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E0_ID_Pos) & M_CAN_TX_EVENT_E0_ID_Msk))
static inline uint32_t m_can_tx_event_e0_id_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E0_ID_Msk) >> M_CAN_TX_EVENT_E0_ID_Pos);
}
static inline uint32_t m_can_tx_event_e0_id_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= UINT32_C(536870911));
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E0_ID_Msk) | M_CAN_TX_EVENT_E0_ID_SET(value));
}
/* Word E1A of TX_EVENT: 8-bit Message Marker, event type, format, length and the internal timestamp.
 * Has this layout only if !CCCR.WMM && !CCCR.UTSU.
 * §2.4.4 p.52
 */
#define M_CAN_TX_EVENT_E1A_OFFSET 0x004U
/* MM[7:0]: Message Marker of the transmitted Tx Buffer. Access rw.
 * §2.4.4 p.51
 */
#define M_CAN_TX_EVENT_E1A_MM_Pos 24U
#define M_CAN_TX_EVENT_E1A_MM_Msk UINT32_C(0xFF000000)
#define M_CAN_TX_EVENT_E1A_MM_Width 8U
#define M_CAN_TX_EVENT_E1A_MM_Access "rw"
#define M_CAN_TX_EVENT_E1A_MM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1A_MM_Pos) & M_CAN_TX_EVENT_E1A_MM_Msk))
static inline uint32_t m_can_tx_event_e1a_mm_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1A_MM_Msk) >> M_CAN_TX_EVENT_E1A_MM_Pos);
}
static inline uint32_t m_can_tx_event_e1a_mm_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 255U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1A_MM_Msk) | M_CAN_TX_EVENT_E1A_MM_SET(value));
}
/* ET: Kind of the event. Access rw. */
#define M_CAN_TX_EVENT_E1A_ET_Pos 22U
#define M_CAN_TX_EVENT_E1A_ET_Msk UINT32_C(0x00C00000)
#define M_CAN_TX_EVENT_E1A_ET_Width 2U
#define M_CAN_TX_EVENT_E1A_ET_Access "rw"
#define M_CAN_TX_EVENT_E1A_ET_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1A_ET_Pos) & M_CAN_TX_EVENT_E1A_ET_Msk))
static inline uint32_t m_can_tx_event_e1a_et_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1A_ET_Msk) >> M_CAN_TX_EVENT_E1A_ET_Pos);
}
static inline uint32_t m_can_tx_event_e1a_et_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1A_ET_Msk) | M_CAN_TX_EVENT_E1A_ET_SET(value));
}
/* FDF: Format of the frame. Access rw. */
#define M_CAN_TX_EVENT_E1A_FDF_Pos 21U
#define M_CAN_TX_EVENT_E1A_FDF_Msk UINT32_C(0x00200000)
#define M_CAN_TX_EVENT_E1A_FDF_Width 1U
#define M_CAN_TX_EVENT_E1A_FDF_Access "rw"
#define M_CAN_TX_EVENT_E1A_FDF_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1A_FDF_Pos) & M_CAN_TX_EVENT_E1A_FDF_Msk))
static inline uint32_t m_can_tx_event_e1a_fdf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1A_FDF_Msk) >> M_CAN_TX_EVENT_E1A_FDF_Pos);
}
static inline uint32_t m_can_tx_event_e1a_fdf_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1A_FDF_Msk) | M_CAN_TX_EVENT_E1A_FDF_SET(value));
}
/* BRS: The frame switched the bit rate. Access rw. */
#define M_CAN_TX_EVENT_E1A_BRS_Pos 20U
#define M_CAN_TX_EVENT_E1A_BRS_Msk UINT32_C(0x00100000)
#define M_CAN_TX_EVENT_E1A_BRS_Width 1U
#define M_CAN_TX_EVENT_E1A_BRS_Access "rw"
#define M_CAN_TX_EVENT_E1A_BRS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1A_BRS_Pos) & M_CAN_TX_EVENT_E1A_BRS_Msk))
static inline uint32_t m_can_tx_event_e1a_brs_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1A_BRS_Msk) >> M_CAN_TX_EVENT_E1A_BRS_Pos);
}
static inline uint32_t m_can_tx_event_e1a_brs_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1A_BRS_Msk) | M_CAN_TX_EVENT_E1A_BRS_SET(value));
}
/* DLC: Data length code. Access rw. */
#define M_CAN_TX_EVENT_E1A_DLC_Pos 16U
#define M_CAN_TX_EVENT_E1A_DLC_Msk UINT32_C(0x000F0000)
#define M_CAN_TX_EVENT_E1A_DLC_Width 4U
#define M_CAN_TX_EVENT_E1A_DLC_Access "rw"
#define M_CAN_TX_EVENT_E1A_DLC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1A_DLC_Pos) & M_CAN_TX_EVENT_E1A_DLC_Msk))
static inline uint32_t m_can_tx_event_e1a_dlc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1A_DLC_Msk) >> M_CAN_TX_EVENT_E1A_DLC_Pos);
}
static inline uint32_t m_can_tx_event_e1a_dlc_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1A_DLC_Msk) | M_CAN_TX_EVENT_E1A_DLC_SET(value));
}
/* TXTS: Timestamp captured at the start of the frame, in the unit set by TSCC.TCP. Access rw. */
#define M_CAN_TX_EVENT_E1A_TXTS_Pos 0U
#define M_CAN_TX_EVENT_E1A_TXTS_Msk UINT32_C(0x0000FFFF)
#define M_CAN_TX_EVENT_E1A_TXTS_Width 16U
#define M_CAN_TX_EVENT_E1A_TXTS_Access "rw"
#define M_CAN_TX_EVENT_E1A_TXTS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1A_TXTS_Pos) & M_CAN_TX_EVENT_E1A_TXTS_Msk))
static inline uint32_t m_can_tx_event_e1a_txts_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1A_TXTS_Msk) >> M_CAN_TX_EVENT_E1A_TXTS_Pos);
}
static inline uint32_t m_can_tx_event_e1a_txts_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 65535U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1A_TXTS_Msk) | M_CAN_TX_EVENT_E1A_TXTS_SET(value));
}
/* Word E1B of TX_EVENT: 16-bit Message Marker, event type, format, length and a reference to a timestamp of the
 * TSU.
 * Has this layout only if CCCR.WMM || CCCR.UTSU.
 * §2.4.4 p.52
 */
#define M_CAN_TX_EVENT_E1B_OFFSET 0x004U
/* MM[7:0]: Low byte of the Message Marker of the transmitted Tx Buffer. Access rw.
 * §2.4.4 p.51
 */
#define M_CAN_TX_EVENT_E1B_MM_Pos 24U
#define M_CAN_TX_EVENT_E1B_MM_Msk UINT32_C(0xFF000000)
#define M_CAN_TX_EVENT_E1B_MM_Width 8U
#define M_CAN_TX_EVENT_E1B_MM_Access "rw"
#define M_CAN_TX_EVENT_E1B_MM_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1B_MM_Pos) & M_CAN_TX_EVENT_E1B_MM_Msk))
static inline uint32_t m_can_tx_event_e1b_mm_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1B_MM_Msk) >> M_CAN_TX_EVENT_E1B_MM_Pos);
}
static inline uint32_t m_can_tx_event_e1b_mm_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 255U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1B_MM_Msk) | M_CAN_TX_EVENT_E1B_MM_SET(value));
}
/* ET: Kind of the event. Access rw. */
#define M_CAN_TX_EVENT_E1B_ET_Pos 22U
#define M_CAN_TX_EVENT_E1B_ET_Msk UINT32_C(0x00C00000)
#define M_CAN_TX_EVENT_E1B_ET_Width 2U
#define M_CAN_TX_EVENT_E1B_ET_Access "rw"
#define M_CAN_TX_EVENT_E1B_ET_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1B_ET_Pos) & M_CAN_TX_EVENT_E1B_ET_Msk))
static inline uint32_t m_can_tx_event_e1b_et_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1B_ET_Msk) >> M_CAN_TX_EVENT_E1B_ET_Pos);
}
static inline uint32_t m_can_tx_event_e1b_et_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1B_ET_Msk) | M_CAN_TX_EVENT_E1B_ET_SET(value));
}
/* FDF: Format of the frame. Access rw. */
#define M_CAN_TX_EVENT_E1B_FDF_Pos 21U
#define M_CAN_TX_EVENT_E1B_FDF_Msk UINT32_C(0x00200000)
#define M_CAN_TX_EVENT_E1B_FDF_Width 1U
#define M_CAN_TX_EVENT_E1B_FDF_Access "rw"
#define M_CAN_TX_EVENT_E1B_FDF_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1B_FDF_Pos) & M_CAN_TX_EVENT_E1B_FDF_Msk))
static inline uint32_t m_can_tx_event_e1b_fdf_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1B_FDF_Msk) >> M_CAN_TX_EVENT_E1B_FDF_Pos);
}
static inline uint32_t m_can_tx_event_e1b_fdf_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1B_FDF_Msk) | M_CAN_TX_EVENT_E1B_FDF_SET(value));
}
/* BRS: The frame switched the bit rate. Access rw. */
#define M_CAN_TX_EVENT_E1B_BRS_Pos 20U
#define M_CAN_TX_EVENT_E1B_BRS_Msk UINT32_C(0x00100000)
#define M_CAN_TX_EVENT_E1B_BRS_Width 1U
#define M_CAN_TX_EVENT_E1B_BRS_Access "rw"
#define M_CAN_TX_EVENT_E1B_BRS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1B_BRS_Pos) & M_CAN_TX_EVENT_E1B_BRS_Msk))
static inline uint32_t m_can_tx_event_e1b_brs_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1B_BRS_Msk) >> M_CAN_TX_EVENT_E1B_BRS_Pos);
}
static inline uint32_t m_can_tx_event_e1b_brs_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1B_BRS_Msk) | M_CAN_TX_EVENT_E1B_BRS_SET(value));
}
/* DLC: Data length code. Access rw. */
#define M_CAN_TX_EVENT_E1B_DLC_Pos 16U
#define M_CAN_TX_EVENT_E1B_DLC_Msk UINT32_C(0x000F0000)
#define M_CAN_TX_EVENT_E1B_DLC_Width 4U
#define M_CAN_TX_EVENT_E1B_DLC_Access "rw"
#define M_CAN_TX_EVENT_E1B_DLC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1B_DLC_Pos) & M_CAN_TX_EVENT_E1B_DLC_Msk))
static inline uint32_t m_can_tx_event_e1b_dlc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1B_DLC_Msk) >> M_CAN_TX_EVENT_E1B_DLC_Pos);
}
static inline uint32_t m_can_tx_event_e1b_dlc_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1B_DLC_Msk) | M_CAN_TX_EVENT_E1B_DLC_SET(value));
}
/* MM[15:8]: High byte of the Message Marker of the transmitted Tx Buffer. Access rw. */
#define M_CAN_TX_EVENT_E1B_MM_HIGH_Pos 8U
#define M_CAN_TX_EVENT_E1B_MM_HIGH_Msk UINT32_C(0x0000FF00)
#define M_CAN_TX_EVENT_E1B_MM_HIGH_Width 8U
#define M_CAN_TX_EVENT_E1B_MM_HIGH_Access "rw"
#define M_CAN_TX_EVENT_E1B_MM_HIGH_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1B_MM_HIGH_Pos) & M_CAN_TX_EVENT_E1B_MM_HIGH_Msk))
static inline uint32_t m_can_tx_event_e1b_mm_high_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1B_MM_HIGH_Msk) >> M_CAN_TX_EVENT_E1B_MM_HIGH_Pos);
}
static inline uint32_t m_can_tx_event_e1b_mm_high_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 255U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1B_MM_HIGH_Msk) | M_CAN_TX_EVENT_E1B_MM_HIGH_SET(value));
}
/* TSC: The TSU captured a timestamp at the end of the frame, because CCCR.UTSU and TSCE of the Tx Buffer are
 * set; TXTSP is valid. Always 0 without the TSU (CCCR.UTSU = 0). Access rw.
 * §2.4.4 p.51; §2.4.4 p.52; §3.2.2 p.64
 */
#define M_CAN_TX_EVENT_E1B_TSC_Pos 4U
#define M_CAN_TX_EVENT_E1B_TSC_Msk UINT32_C(0x00000010)
#define M_CAN_TX_EVENT_E1B_TSC_Width 1U
#define M_CAN_TX_EVENT_E1B_TSC_Access "rw"
#define M_CAN_TX_EVENT_E1B_TSC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1B_TSC_Pos) & M_CAN_TX_EVENT_E1B_TSC_Msk))
static inline uint32_t m_can_tx_event_e1b_tsc_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1B_TSC_Msk) >> M_CAN_TX_EVENT_E1B_TSC_Pos);
}
static inline uint32_t m_can_tx_event_e1b_tsc_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1B_TSC_Msk) | M_CAN_TX_EVENT_E1B_TSC_SET(value));
}
/* TXTSP: Number of the TSU timestamp register that holds the timestamp. Access rw. */
#define M_CAN_TX_EVENT_E1B_TXTSP_Pos 0U
#define M_CAN_TX_EVENT_E1B_TXTSP_Msk UINT32_C(0x0000000F)
#define M_CAN_TX_EVENT_E1B_TXTSP_Width 4U
#define M_CAN_TX_EVENT_E1B_TXTSP_Access "rw"
#define M_CAN_TX_EVENT_E1B_TXTSP_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_TX_EVENT_E1B_TXTSP_Pos) & M_CAN_TX_EVENT_E1B_TXTSP_Msk))
static inline uint32_t m_can_tx_event_e1b_txtsp_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_TX_EVENT_E1B_TXTSP_Msk) >> M_CAN_TX_EVENT_E1B_TXTSP_Pos);
}
static inline uint32_t m_can_tx_event_e1b_txtsp_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 15U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_TX_EVENT_E1B_TXTSP_Msk) | M_CAN_TX_EVENT_E1B_TXTSP_SET(value));
}
/* MESSAGE_MARKER: 16-bit wide Message Marker.
 * §2.4.4 p.51
 */
static inline uint32_t m_can_tx_event_message_marker_read(const m_can_tx_event_t *element)
{
    const uint32_t part0 = element->E1A_E1B;
    return ((uint32_t)((part0 & UINT32_C(0xFF000000)) >> 24U) << 0U) | ((uint32_t)((part0 & UINT32_C(0x0000FF00)) >> 8U) << 8U);
}
static inline void m_can_tx_event_message_marker_write(m_can_tx_event_t *element, uint32_t value)
{
    element->E1A_E1B = (uint32_t)((element->E1A_E1B & (uint32_t)~UINT32_C(0xFF00FF00)) | (uint32_t)(((uint32_t)(value >> 0U) << 24U) & UINT32_C(0xFF000000)) | (uint32_t)(((uint32_t)(value >> 8U) << 8U) & UINT32_C(0x0000FF00)));
}

/* STANDARD_FILTER: Standard Message ID Filter Element.
 * Filter for frames with 11-bit identifiers. Elements are tried from index 0; the first match ends the
 * filtering.
 * §2.4.5 Table 52 p.52
 */
typedef struct {
    volatile uint32_t S0_S0_RX_BUFFER; /* Filter that stores in a FIFO, rejects or sets priority, or an element that is skipped. */
} m_can_standard_filter_t;
M_CAN_STATIC_ASSERT(offsetof(m_can_standard_filter_t, S0_S0_RX_BUFFER) == 0x000U, m_can_standard_filter_at_S0_S0_RX_BUFFER);
M_CAN_STATIC_ASSERT(sizeof(m_can_standard_filter_t) == 0x004U, m_can_standard_filter_size);
#define M_CAN_STANDARD_FILTER_HEADER_BYTES 4U
/* Word S0 of STANDARD_FILTER: Filter that stores in a FIFO, rejects or sets priority, or an element that is
 * skipped.
 * Has this layout only if S0.SFEC != rx_buffer.
 * §2.4.5 p.52; §2.4.5 p.53
 */
#define M_CAN_STANDARD_FILTER_S0_OFFSET 0x000U
/* SFT: Type of the filter. Access rw. */
#define M_CAN_STANDARD_FILTER_S0_SFT_Pos 30U
#define M_CAN_STANDARD_FILTER_S0_SFT_Msk UINT32_C(0xC0000000)
#define M_CAN_STANDARD_FILTER_S0_SFT_Width 2U
#define M_CAN_STANDARD_FILTER_S0_SFT_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_SFT_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_SFT_Pos) & M_CAN_STANDARD_FILTER_S0_SFT_Msk))
static inline uint32_t m_can_standard_filter_s0_sft_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_SFT_Msk) >> M_CAN_STANDARD_FILTER_S0_SFT_Pos);
}
static inline uint32_t m_can_standard_filter_s0_sft_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_SFT_Msk) | M_CAN_STANDARD_FILTER_S0_SFT_SET(value));
}
/* SFEC: What a match does. Access rw. */
#define M_CAN_STANDARD_FILTER_S0_SFEC_Pos 27U
#define M_CAN_STANDARD_FILTER_S0_SFEC_Msk UINT32_C(0x38000000)
#define M_CAN_STANDARD_FILTER_S0_SFEC_Width 3U
#define M_CAN_STANDARD_FILTER_S0_SFEC_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_SFEC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_SFEC_Pos) & M_CAN_STANDARD_FILTER_S0_SFEC_Msk))
static inline uint32_t m_can_standard_filter_s0_sfec_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_SFEC_Msk) >> M_CAN_STANDARD_FILTER_S0_SFEC_Pos);
}
static inline uint32_t m_can_standard_filter_s0_sfec_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_SFEC_Msk) | M_CAN_STANDARD_FILTER_S0_SFEC_SET(value));
}
/* SFID1: First identifier of the element. Access rw. */
#define M_CAN_STANDARD_FILTER_S0_SFID1_Pos 16U
#define M_CAN_STANDARD_FILTER_S0_SFID1_Msk UINT32_C(0x07FF0000)
#define M_CAN_STANDARD_FILTER_S0_SFID1_Width 11U
#define M_CAN_STANDARD_FILTER_S0_SFID1_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_SFID1_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_SFID1_Pos) & M_CAN_STANDARD_FILTER_S0_SFID1_Msk))
static inline uint32_t m_can_standard_filter_s0_sfid1_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_SFID1_Msk) >> M_CAN_STANDARD_FILTER_S0_SFID1_Pos);
}
static inline uint32_t m_can_standard_filter_s0_sfid1_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 2047U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_SFID1_Msk) | M_CAN_STANDARD_FILTER_S0_SFID1_SET(value));
}
/* SSYNC: Has the TSU capture a timestamp of a matching message (pulse at m_can_tsrx), whether the message is
 * stored or not. Only with CCCR.UTSU set. Access rw.
 */
#define M_CAN_STANDARD_FILTER_S0_SSYNC_Pos 15U
#define M_CAN_STANDARD_FILTER_S0_SSYNC_Msk UINT32_C(0x00008000)
#define M_CAN_STANDARD_FILTER_S0_SSYNC_Width 1U
#define M_CAN_STANDARD_FILTER_S0_SSYNC_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_SSYNC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_SSYNC_Pos) & M_CAN_STANDARD_FILTER_S0_SSYNC_Msk))
static inline uint32_t m_can_standard_filter_s0_ssync_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_SSYNC_Msk) >> M_CAN_STANDARD_FILTER_S0_SSYNC_Pos);
}
static inline uint32_t m_can_standard_filter_s0_ssync_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_SSYNC_Msk) | M_CAN_STANDARD_FILTER_S0_SSYNC_SET(value));
}
/* SFID2: Second identifier or mask of the element. Access rw. */
#define M_CAN_STANDARD_FILTER_S0_SFID2_Pos 0U
#define M_CAN_STANDARD_FILTER_S0_SFID2_Msk UINT32_C(0x000007FF)
#define M_CAN_STANDARD_FILTER_S0_SFID2_Width 11U
#define M_CAN_STANDARD_FILTER_S0_SFID2_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_SFID2_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_SFID2_Pos) & M_CAN_STANDARD_FILTER_S0_SFID2_Msk))
static inline uint32_t m_can_standard_filter_s0_sfid2_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_SFID2_Msk) >> M_CAN_STANDARD_FILTER_S0_SFID2_Pos);
}
static inline uint32_t m_can_standard_filter_s0_sfid2_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 2047U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_SFID2_Msk) | M_CAN_STANDARD_FILTER_S0_SFID2_SET(value));
}
/* Word S0_RX_BUFFER of STANDARD_FILTER: The same word with the action rx_buffer, which gives the second ID
 * another meaning: the message goes to a dedicated Rx Buffer or is a debug message. The received identifier has
 * to equal SFID1.
 * Has this layout only if S0.SFEC == rx_buffer.
 * §2.4.5 p.52; §2.4.5 p.53
 */
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_OFFSET 0x000U
/* SFT: Ignored in this layout. Access rw. */
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFT_Pos 30U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFT_Msk UINT32_C(0xC0000000)
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFT_Width 2U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFT_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFT_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFT_Pos) & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFT_Msk))
static inline uint32_t m_can_standard_filter_s0_rx_buffer_sft_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFT_Msk) >> M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFT_Pos);
}
static inline uint32_t m_can_standard_filter_s0_rx_buffer_sft_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFT_Msk) | M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFT_SET(value));
}
/* SFEC: What a match does: rx_buffer in this layout. Access rw. */
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFEC_Pos 27U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFEC_Msk UINT32_C(0x38000000)
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFEC_Width 3U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFEC_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFEC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFEC_Pos) & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFEC_Msk))
static inline uint32_t m_can_standard_filter_s0_rx_buffer_sfec_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFEC_Msk) >> M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFEC_Pos);
}
static inline uint32_t m_can_standard_filter_s0_rx_buffer_sfec_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFEC_Msk) | M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFEC_SET(value));
}
/* SFID1: The identifier, compared without a mask. Access rw. */
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFID1_Pos 16U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFID1_Msk UINT32_C(0x07FF0000)
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFID1_Width 11U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFID1_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFID1_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFID1_Pos) & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFID1_Msk))
static inline uint32_t m_can_standard_filter_s0_rx_buffer_sfid1_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFID1_Msk) >> M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFID1_Pos);
}
static inline uint32_t m_can_standard_filter_s0_rx_buffer_sfid1_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 2047U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFID1_Msk) | M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SFID1_SET(value));
}
/* SSYNC: Has the TSU capture a timestamp of a matching message (pulse at m_can_tsrx), whether the message is
 * stored or not. Only with CCCR.UTSU set. Access rw.
 */
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SSYNC_Pos 15U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SSYNC_Msk UINT32_C(0x00008000)
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SSYNC_Width 1U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SSYNC_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SSYNC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SSYNC_Pos) & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SSYNC_Msk))
static inline uint32_t m_can_standard_filter_s0_rx_buffer_ssync_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SSYNC_Msk) >> M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SSYNC_Pos);
}
static inline uint32_t m_can_standard_filter_s0_rx_buffer_ssync_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SSYNC_Msk) | M_CAN_STANDARD_FILTER_S0_RX_BUFFER_SSYNC_SET(value));
}
/* SFID2[10:9]: Rx Buffer or debug message A, B or C. Access rw. */
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_DESTINATION_Pos 9U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_DESTINATION_Msk UINT32_C(0x00000600)
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_DESTINATION_Width 2U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_DESTINATION_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_DESTINATION_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_RX_BUFFER_DESTINATION_Pos) & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_DESTINATION_Msk))
static inline uint32_t m_can_standard_filter_s0_rx_buffer_destination_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_DESTINATION_Msk) >> M_CAN_STANDARD_FILTER_S0_RX_BUFFER_DESTINATION_Pos);
}
static inline uint32_t m_can_standard_filter_s0_rx_buffer_destination_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_RX_BUFFER_DESTINATION_Msk) | M_CAN_STANDARD_FILTER_S0_RX_BUFFER_DESTINATION_SET(value));
}
/* SFID2[8:6]: A 1 makes a match pulse the filter event pin of that bit (m_can_fe[2:0]) for one Host clock
 * period. Access rw.
 */
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_EVENT_PINS_Pos 6U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_EVENT_PINS_Msk UINT32_C(0x000001C0)
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_EVENT_PINS_Width 3U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_EVENT_PINS_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_EVENT_PINS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_RX_BUFFER_EVENT_PINS_Pos) & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_EVENT_PINS_Msk))
static inline uint32_t m_can_standard_filter_s0_rx_buffer_event_pins_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_EVENT_PINS_Msk) >> M_CAN_STANDARD_FILTER_S0_RX_BUFFER_EVENT_PINS_Pos);
}
static inline uint32_t m_can_standard_filter_s0_rx_buffer_event_pins_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_RX_BUFFER_EVENT_PINS_Msk) | M_CAN_STANDARD_FILTER_S0_RX_BUFFER_EVENT_PINS_SET(value));
}
/* SFID2[5:0]: Number of the Rx Buffer, counted from RXBC.RBSA, that takes the message. Access rw. */
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_BUFFER_Pos 0U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_BUFFER_Msk UINT32_C(0x0000003F)
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_BUFFER_Width 6U
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_BUFFER_Access "rw"
#define M_CAN_STANDARD_FILTER_S0_RX_BUFFER_BUFFER_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_STANDARD_FILTER_S0_RX_BUFFER_BUFFER_Pos) & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_BUFFER_Msk))
static inline uint32_t m_can_standard_filter_s0_rx_buffer_buffer_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_STANDARD_FILTER_S0_RX_BUFFER_BUFFER_Msk) >> M_CAN_STANDARD_FILTER_S0_RX_BUFFER_BUFFER_Pos);
}
static inline uint32_t m_can_standard_filter_s0_rx_buffer_buffer_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 63U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_STANDARD_FILTER_S0_RX_BUFFER_BUFFER_Msk) | M_CAN_STANDARD_FILTER_S0_RX_BUFFER_BUFFER_SET(value));
}

/* EXTENDED_FILTER: Extended Message ID Filter Element.
 * Filter for frames with 29-bit identifiers. Elements are tried from index 0; the first match ends the
 * filtering.
 * §2.4.6 Table 53 p.54
 */
typedef struct {
    volatile uint32_t F0; /* Action and first identifier. */
    volatile uint32_t F1_F1_RX_BUFFER; /* Type and second identifier of a filter that stores in a FIFO, rejects or sets priority, or of an element that is skipped. */
} m_can_extended_filter_t;
M_CAN_STATIC_ASSERT(offsetof(m_can_extended_filter_t, F0) == 0x000U, m_can_extended_filter_at_F0);
M_CAN_STATIC_ASSERT(offsetof(m_can_extended_filter_t, F1_F1_RX_BUFFER) == 0x004U, m_can_extended_filter_at_F1_F1_RX_BUFFER);
M_CAN_STATIC_ASSERT(sizeof(m_can_extended_filter_t) == 0x008U, m_can_extended_filter_size);
#define M_CAN_EXTENDED_FILTER_HEADER_BYTES 8U
/* Word F0 of EXTENDED_FILTER: Action and first identifier.
 * §2.4.6 Table 53 p.54
 */
#define M_CAN_EXTENDED_FILTER_F0_OFFSET 0x000U
/* EFEC: What a match does. Access rw. */
#define M_CAN_EXTENDED_FILTER_F0_EFEC_Pos 29U
#define M_CAN_EXTENDED_FILTER_F0_EFEC_Msk UINT32_C(0xE0000000)
#define M_CAN_EXTENDED_FILTER_F0_EFEC_Width 3U
#define M_CAN_EXTENDED_FILTER_F0_EFEC_Access "rw"
#define M_CAN_EXTENDED_FILTER_F0_EFEC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_EXTENDED_FILTER_F0_EFEC_Pos) & M_CAN_EXTENDED_FILTER_F0_EFEC_Msk))
static inline uint32_t m_can_extended_filter_f0_efec_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_EXTENDED_FILTER_F0_EFEC_Msk) >> M_CAN_EXTENDED_FILTER_F0_EFEC_Pos);
}
static inline uint32_t m_can_extended_filter_f0_efec_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_EXTENDED_FILTER_F0_EFEC_Msk) | M_CAN_EXTENDED_FILTER_F0_EFEC_SET(value));
}
/* EFID1: First identifier of the element. For Rx Buffers and debug messages the received identifier, ANDed with
 * XIDAM, has to equal it. Access rw.
 */
#define M_CAN_EXTENDED_FILTER_F0_EFID1_Pos 0U
#define M_CAN_EXTENDED_FILTER_F0_EFID1_Msk UINT32_C(0x1FFFFFFF)
#define M_CAN_EXTENDED_FILTER_F0_EFID1_Width 29U
#define M_CAN_EXTENDED_FILTER_F0_EFID1_Access "rw"
#define M_CAN_EXTENDED_FILTER_F0_EFID1_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_EXTENDED_FILTER_F0_EFID1_Pos) & M_CAN_EXTENDED_FILTER_F0_EFID1_Msk))
static inline uint32_t m_can_extended_filter_f0_efid1_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_EXTENDED_FILTER_F0_EFID1_Msk) >> M_CAN_EXTENDED_FILTER_F0_EFID1_Pos);
}
static inline uint32_t m_can_extended_filter_f0_efid1_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= UINT32_C(536870911));
    return (uint32_t)((reg & (uint32_t)~M_CAN_EXTENDED_FILTER_F0_EFID1_Msk) | M_CAN_EXTENDED_FILTER_F0_EFID1_SET(value));
}
/* Word F1 of EXTENDED_FILTER: Type and second identifier of a filter that stores in a FIFO, rejects or sets
 * priority, or of an element that is skipped.
 * Has this layout only if F0.EFEC != rx_buffer.
 * §2.4.6 p.54; §2.4.6 p.55
 */
#define M_CAN_EXTENDED_FILTER_F1_OFFSET 0x004U
/* EFT: Type of the filter. Access rw. */
#define M_CAN_EXTENDED_FILTER_F1_EFT_Pos 30U
#define M_CAN_EXTENDED_FILTER_F1_EFT_Msk UINT32_C(0xC0000000)
#define M_CAN_EXTENDED_FILTER_F1_EFT_Width 2U
#define M_CAN_EXTENDED_FILTER_F1_EFT_Access "rw"
#define M_CAN_EXTENDED_FILTER_F1_EFT_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_EXTENDED_FILTER_F1_EFT_Pos) & M_CAN_EXTENDED_FILTER_F1_EFT_Msk))
static inline uint32_t m_can_extended_filter_f1_eft_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_EXTENDED_FILTER_F1_EFT_Msk) >> M_CAN_EXTENDED_FILTER_F1_EFT_Pos);
}
static inline uint32_t m_can_extended_filter_f1_eft_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_EXTENDED_FILTER_F1_EFT_Msk) | M_CAN_EXTENDED_FILTER_F1_EFT_SET(value));
}
/* ESYNC: Has the TSU capture a timestamp of a matching message (pulse at m_can_tsrx), whether the message is
 * stored or not. Only with CCCR.UTSU set. Access rw.
 */
#define M_CAN_EXTENDED_FILTER_F1_ESYNC_Pos 29U
#define M_CAN_EXTENDED_FILTER_F1_ESYNC_Msk UINT32_C(0x20000000)
#define M_CAN_EXTENDED_FILTER_F1_ESYNC_Width 1U
#define M_CAN_EXTENDED_FILTER_F1_ESYNC_Access "rw"
#define M_CAN_EXTENDED_FILTER_F1_ESYNC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_EXTENDED_FILTER_F1_ESYNC_Pos) & M_CAN_EXTENDED_FILTER_F1_ESYNC_Msk))
static inline uint32_t m_can_extended_filter_f1_esync_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_EXTENDED_FILTER_F1_ESYNC_Msk) >> M_CAN_EXTENDED_FILTER_F1_ESYNC_Pos);
}
static inline uint32_t m_can_extended_filter_f1_esync_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_EXTENDED_FILTER_F1_ESYNC_Msk) | M_CAN_EXTENDED_FILTER_F1_ESYNC_SET(value));
}
/* EFID2: Second identifier or mask of the element. Access rw. */
#define M_CAN_EXTENDED_FILTER_F1_EFID2_Pos 0U
#define M_CAN_EXTENDED_FILTER_F1_EFID2_Msk UINT32_C(0x1FFFFFFF)
#define M_CAN_EXTENDED_FILTER_F1_EFID2_Width 29U
#define M_CAN_EXTENDED_FILTER_F1_EFID2_Access "rw"
#define M_CAN_EXTENDED_FILTER_F1_EFID2_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_EXTENDED_FILTER_F1_EFID2_Pos) & M_CAN_EXTENDED_FILTER_F1_EFID2_Msk))
static inline uint32_t m_can_extended_filter_f1_efid2_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_EXTENDED_FILTER_F1_EFID2_Msk) >> M_CAN_EXTENDED_FILTER_F1_EFID2_Pos);
}
static inline uint32_t m_can_extended_filter_f1_efid2_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= UINT32_C(536870911));
    return (uint32_t)((reg & (uint32_t)~M_CAN_EXTENDED_FILTER_F1_EFID2_Msk) | M_CAN_EXTENDED_FILTER_F1_EFID2_SET(value));
}
/* Word F1_RX_BUFFER of EXTENDED_FILTER: The same word with the action rx_buffer, in which the second ID tells
 * where the message goes.
 * Has this layout only if F0.EFEC == rx_buffer.
 * §2.4.6 p.54; §2.4.6 p.55
 */
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_OFFSET 0x004U
/* EFT: Ignored in this layout. Access rw. */
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EFT_Pos 30U
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EFT_Msk UINT32_C(0xC0000000)
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EFT_Width 2U
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EFT_Access "rw"
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EFT_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EFT_Pos) & M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EFT_Msk))
static inline uint32_t m_can_extended_filter_f1_rx_buffer_eft_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EFT_Msk) >> M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EFT_Pos);
}
static inline uint32_t m_can_extended_filter_f1_rx_buffer_eft_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EFT_Msk) | M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EFT_SET(value));
}
/* ESYNC: Has the TSU capture a timestamp of a matching message (pulse at m_can_tsrx), whether the message is
 * stored or not. Only with CCCR.UTSU set. Access rw.
 */
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_ESYNC_Pos 29U
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_ESYNC_Msk UINT32_C(0x20000000)
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_ESYNC_Width 1U
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_ESYNC_Access "rw"
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_ESYNC_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_ESYNC_Pos) & M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_ESYNC_Msk))
static inline uint32_t m_can_extended_filter_f1_rx_buffer_esync_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_ESYNC_Msk) >> M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_ESYNC_Pos);
}
static inline uint32_t m_can_extended_filter_f1_rx_buffer_esync_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 1U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_ESYNC_Msk) | M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_ESYNC_SET(value));
}
/* EFID2[10:9]: Rx Buffer or debug message A, B or C. Access rw. */
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_DESTINATION_Pos 9U
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_DESTINATION_Msk UINT32_C(0x00000600)
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_DESTINATION_Width 2U
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_DESTINATION_Access "rw"
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_DESTINATION_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_DESTINATION_Pos) & M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_DESTINATION_Msk))
static inline uint32_t m_can_extended_filter_f1_rx_buffer_destination_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_DESTINATION_Msk) >> M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_DESTINATION_Pos);
}
static inline uint32_t m_can_extended_filter_f1_rx_buffer_destination_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 3U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_DESTINATION_Msk) | M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_DESTINATION_SET(value));
}
/* EFID2[8:6]: A 1 makes a match pulse the filter event pin of that bit (m_can_fe[2:0]) for one Host clock
 * period. Access rw.
 */
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EVENT_PINS_Pos 6U
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EVENT_PINS_Msk UINT32_C(0x000001C0)
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EVENT_PINS_Width 3U
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EVENT_PINS_Access "rw"
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EVENT_PINS_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EVENT_PINS_Pos) & M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EVENT_PINS_Msk))
static inline uint32_t m_can_extended_filter_f1_rx_buffer_event_pins_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EVENT_PINS_Msk) >> M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EVENT_PINS_Pos);
}
static inline uint32_t m_can_extended_filter_f1_rx_buffer_event_pins_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 7U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EVENT_PINS_Msk) | M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_EVENT_PINS_SET(value));
}
/* EFID2[5:0]: Number of the Rx Buffer, counted from RXBC.RBSA, that takes the message. Access rw. */
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_BUFFER_Pos 0U
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_BUFFER_Msk UINT32_C(0x0000003F)
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_BUFFER_Width 6U
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_BUFFER_Access "rw"
#define M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_BUFFER_SET(value) ((uint32_t)(((uint32_t)(value) << M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_BUFFER_Pos) & M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_BUFFER_Msk))
static inline uint32_t m_can_extended_filter_f1_rx_buffer_buffer_get(uint32_t reg)
{
    return (uint32_t)((reg & M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_BUFFER_Msk) >> M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_BUFFER_Pos);
}
static inline uint32_t m_can_extended_filter_f1_rx_buffer_buffer_set(uint32_t reg, uint32_t value)
{
    M_CAN_ASSERT(value <= 63U);
    return (uint32_t)((reg & (uint32_t)~M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_BUFFER_Msk) | M_CAN_EXTENDED_FILTER_F1_RX_BUFFER_BUFFER_SET(value));
}

#ifdef __cplusplus
}
#endif

#endif /* M_CAN_H */
