"""The structures that come with the controller of TIA Portal: connections, addresses, errors.

They are written as the text of TYPEs, read when a program first names one. Source: TIA Portal help,
"System data types", "TCON_IP_v4", "TCON_Param", "GET_ERROR" and "SET_TIMEZONE".
"""

from functools import cache

from fbgen.lang import ast
from fbgen.lang.parser import parse
from fbgen.source import Source

_CONNECTION = """
      InterfaceId : HW_ANY;
      ID : CONN_OUC;
      ConnectionType : Byte := 16#0B;
"""
_TEXT = f"""
TYPE IP_V4
   STRUCT
      ADDR : Array[1..4] of Byte;
   END_STRUCT;
END_TYPE
TYPE TSelector
   STRUCT
      TSelLength : UInt;
      TSel : Array[1..32] of Byte;
   END_STRUCT;
END_TYPE
TYPE TCON_Configured
   STRUCT {_CONNECTION}
   END_STRUCT;
END_TYPE
TYPE TCON_IP_v4
   STRUCT {_CONNECTION}
      ActiveEstablished : Bool;
      RemoteAddress : IP_V4;
      RemotePort : UInt;
      LocalPort : UInt;
   END_STRUCT;
END_TYPE
TYPE TCON_IP_V4_SEC
   STRUCT
      ConnPara : TCON_IP_v4;
      ActivateSecureConn : Bool;
      TLSServerReqClientCert : Bool;
      ExtTLSCapabilities : Word;
      TLSServerCertRef : UDInt;
      TLSClientCertRef : UDInt;
   END_STRUCT;
END_TYPE
TYPE TCON_IP_RFC
   STRUCT {_CONNECTION}
      ActiveEstablished : Bool;
      RemoteAddress : IP_V4;
      RemoteTSelector : TSelector;
      LocalTSelector : TSelector;
   END_STRUCT;
END_TYPE
TYPE TCON_QDN
   STRUCT {_CONNECTION}
      ActiveEstablished : Bool;
      RemoteQDN : String[254];
      RemotePort : UInt;
      LocalPort : UInt;
   END_STRUCT;
END_TYPE
TYPE TCON_Param
   STRUCT
      block_length : UInt := 64;
      id : CONN_OUC;
      connection_type : USInt := 17;
      active_est : Bool;
      local_device_id : USInt;
      local_tsap_id_len : USInt;
      rem_subnet_id_len : USInt;
      rem_staddr_len : USInt;
      rem_tsap_id_len : USInt;
      next_staddr_len : USInt;
      local_tsap_id : Array[1..16] of Byte;
      rem_subnet_id : Array[1..6] of USInt;
      rem_staddr : Array[1..6] of USInt;
      rem_tsap_id : Array[1..16] of Byte;
      next_staddr : Array[1..6] of Byte;
      spare : Word;
   END_STRUCT;
END_TYPE
TYPE TADDR_Param
   STRUCT
      rem_ip_addr : Array[1..4] of USInt;
      rem_port_nr : UInt;
      spare : Word;
   END_STRUCT;
END_TYPE
TYPE SI_classic
   STRUCT
      EV_CLASS : Byte;
      EV_NUM : Byte;
      PRIORITY : Byte;
      NUM : Byte;
      TYP2_3 : Byte;
      TYP1 : Byte;
      ZI1 : Word;
      ZI2_3 : DWord;
   END_STRUCT;
END_TYPE
TYPE SI_none
   STRUCT
      SI_Format : USInt;
      OB_Class : USInt;
      OB_Nr : UInt;
   END_STRUCT;
END_TYPE
TYPE CREF
   STRUCT
      BLOCK_TYPE : Byte;
      CB_NUMBER : UInt;
      OFFSET : UDInt;
   END_STRUCT;
END_TYPE
TYPE NREF
   STRUCT
      AREA : Byte;
      DB_NUMBER : UInt;
      OFFSET : UDInt;
   END_STRUCT;
END_TYPE
TYPE ErrorStruct
   STRUCT
      ERROR_ID : Word;
      FLAGS : Byte;
      REACTION : Byte;
      CODE_ADDRESS : CREF;
      MODE : Byte;
      OPERAND_NUMBER : UInt;
      POINTER_NUMBER_LOCATION : UInt;
      SLOT_NUMBER_SCOPE : UInt;
      DATA_ADDRESS : NREF;
   END_STRUCT;
END_TYPE
TYPE TimeTransformationRule
   STRUCT
      Bias : Int;
      DaylightBias : Int;
      DaylightStartMonth : USInt;
      DaylightStartWeek : USInt;
      DaylightStartWeekday : USInt;
      DaylightStartHour : USInt;
      DaylightStartMinute : USInt;
      StandardStartMonth : USInt;
      StandardStartWeek : USInt;
      StandardStartWeekday : USInt;
      StandardStartHour : USInt;
      StandardStartMinute : USInt;
      TimeZoneName : String[80];
   END_STRUCT;
END_TYPE
"""
_ALIASES = {"error_struct": "errorstruct"}


def system_type(name: str) -> ast.TypeDeclaration | None:
    """The declaration of the controller's structure with that name, whatever its case."""
    key = name.casefold()
    return _declarations().get(_ALIASES.get(key, key))


@cache
def _declarations() -> dict[str, ast.TypeDeclaration]:
    units = parse(Source("system data types", _TEXT), "tia").units
    return {one.name.name.casefold(): one for one in units if isinstance(one, ast.TypeDeclaration)}
