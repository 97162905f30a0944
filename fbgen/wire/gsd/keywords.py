"""The keywords of GSD files (PROFIBUS guideline 2.122), as they are spelled.

They serve to tell a slip of the pen from a keyword that fbgen does not need. The list was compiled
from public GSD files and readers of them; a keyword that is missing here is kept all the same.
"""

RATES = ("9.6", "19.2", "31.25", "45.45", "93.75", "187.5", "500", "1.5M", "3M", "6M", "12M")
"""The transmission rates as keywords name them, in kbit/s, or in Mbit/s with an M."""

BLOCKS = {
    "prmtext": "EndPrmText",
    "extuserprmdata": "EndExtUserPrmData",
    "module": "EndModule",
    "slotdefinition": "EndSlotDefinition",
    "unitdiagtype": "EndUnitDiagType",
    "unit_diag_area": "Unit_Diag_Area_End",
    "x_unit_diag_area": "X_Unit_Diag_Area_End",
    "data_area_beg": "Data_Area_End",
    "physical_interface": "End_Physical_Interface",
    "version_firmware_download": "End_Version_Firmware_Download",
}
"""What begins a block, in small letters -> what ends it."""

MAY_STAND_ALONE = frozenset({"physical_interface"})
"""Keywords that begin a block in newer files and are a plain value in older ones."""

NESTED = {"data_area_beg": "module", "x_unit_diag_area": "unitdiagtype"}
"""Blocks that stand in others -> in which."""

_TYPES = (
    "Unsigned8 Unsigned16 Unsigned32 Signed8 Signed16 Signed32 Bit BitArea "
    "VisibleString OctetString"
)

_PER_RATE = "MaxTsdr Trdy Tqui Tset Tsdi Transmission_Delay Reaction_Delay TsdrMin"

_OTHERS = """
GSD_Revision Vendor_Name Model_Name Revision Revision_Number Ident_Number Protocol_Ident
Station_Type FMS_supp Hardware_Release Software_Release Redundancy Repeater_Ctrl_Sig 24V_Pins
Implementation_Type Bitmap_Device Bitmap_Diag Bitmap_SF Info_Text Freeze_Mode_supp Sync_Mode_supp
Auto_Baud_supp Set_Slave_Add_supp User_Prm_Data_Len User_Prm_Data User_Prm_Data_Def
Max_User_Prm_Data_Len Min_Slave_Intervall Modular_Station Max_Module Max_Input_Len Max_Output_Len
Max_Data_Len Max_Diag_Data_Len Modul_Offset Slave_Family Family_Name OrderNumber Fail_Safe
Fail_Safe_required Diag_Update_Delay Unit_Diag_Bit Unit_Diag_Bit_Help Unit_Diag_Not_Bit
Unit_Diag_Not_Bit_Help X_Unit_Diag_Bit X_Unit_Diag_Bit_Help X_Unit_Diag_Not_Bit
X_Unit_Diag_Not_Bit_Help Unit_Diag_Type Value X_Value Channel_Diag Channel_Diag_Help Slot Text
Text_Help Prm_Text_Ref Changeable Visible Ext_User_Prm_Data_Ref Ext_User_Prm_Data_Const
X_Ext_User_Prm_Data_Ref X_Ext_User_Prm_Data_Const F_Ext_User_Prm_Data_Ref
F_Ext_User_Prm_Data_Const Max_iParameter_Size F_ParamDescr_CRC Ext_Module_Prm_Data_Len
X_Ext_Module_Prm_Data_Len F_Ext_Module_Prm_Data_Len X_Max_User_Prm_Data_Len
Module_Reference Preset FixPresetModules OnlyNormalModules
DPV1_Slave DPV1_Slave_required DPV1_Data_Types WD_Base_1ms_supp Check_Cfg_Mode Publisher_supp
Subscriber_supp Prm_Block_Structure_supp Prm_Block_Structure_req PrmCmd_supp
Slave_Max_Switch_Over_Time Slave_Redundancy_supp Ident_Maintenance_supp Time_Sync_supp
Max_Initiate_PDU_Length
C1_Read_Write_supp C1_Read_Write_required C1_Max_Data_Len C1_Response_Timeout
C2_Read_Write_supp C2_Read_Write_required C2_Max_Data_Len C2_Response_Timeout
C2_Max_Count_Channels Diagnostic_Alarm_supp Process_Alarm_supp Pull_Plug_Alarm_supp
Status_Alarm_supp Update_Alarm_supp Manufacturer_Specific_Alarm_supp Extra_Alarm_SAP_supp
Alarm_Sequence_Mode_Count Alarm_Type_Mode_supp Diagnostic_Alarm_required Process_Alarm_required
Pull_Plug_Alarm_required Status_Alarm_required Update_Alarm_required
Manufacturer_Specific_Alarm_required Isochron_Mode_supp Isochron_Mode_required TBASE_DP TDP_MIN
TDP_MAX T_PLL_W_MAX TBASE_IO TI_MIN TO_MIN Max_DXB_Links Max_Bcast_Links DXB_Max_Link_Count
DXB_Max_Data_Length DXB_Subscribertable_Block_Location Jokerblock_supp Jokerblock_Slot
Jokerblock_Location PrmText ExtUserPrmData Module SlotDefinition UnitDiagType Unit_Diag_Area
X_Unit_Diag_Area Data_Area_Beg Physical_Interface Version_Firmware_Download
Related_CFG_Identifier IO_Direction Length Consistency Publisher_allowed
DP_Master_allowed Data_Type Max_Lsdu_MS Max_Lsdu_MM Min_Poll_Timeout LAS_Len Max_Slaves_supp
Max_Master_Input_Len Max_Master_Output_Len Max_Master_Data_Len Download_supp Upload_supp
Act_Para_Brct_supp Act_Param_supp Max_MPS_Length Master_Freeze_Mode_supp Master_Sync_Mode_supp
Master_Fail_Safe_supp DPV1_Master DPV1_Conformance_Class C1_Master_Read_Write_supp
Isochron_Mode_Synchronised DXB_Master_supp X_Master_Prm_SAP_supp X_Prm_SAP_supp
S7HeaderCnf OffsetFirstMPDBlock ETERDelay MaxResponseDelay IsActive DiagBufferable
"""


def _all() -> dict[str, str]:
    names = [*_OTHERS.split(), *_TYPES.split(), *BLOCKS.values()]
    names += [f"{rate}_supp" for rate in RATES]
    names += [f"{start}_{rate}" for start in _PER_RATE.split() for rate in RATES]
    return {name.lower(): name for name in names}


KEYWORDS = _all()
"""A keyword in small letters -> as it is spelled."""
