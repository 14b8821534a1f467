package lightning.format.mesh.ply;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import lightning.format.mesh.ByteSource;

/** Number type in a PLY file. */
enum PlyType {
    INT8(1, 0), UINT8(1, 0xFF), INT16(2, 0), UINT16(2, 0xFFFF), INT32(4, 0), UINT32(4, 0xFFFF_FFFFL), FLOAT32(4, 0), FLOAT64(8, 0);

    /** Original type names, and names with explicit sizes. */
    private static final Map<String, PlyType> NAMES = Map.ofEntries(Map.entry("char", INT8), Map.entry("uchar", UINT8),
            Map.entry("short", INT16), Map.entry("ushort", UINT16), Map.entry("int", INT32), Map.entry("uint", UINT32),
            Map.entry("float", FLOAT32), Map.entry("double", FLOAT64), Map.entry("int8", INT8), Map.entry("uint8", UINT8),
            Map.entry("int16", INT16), Map.entry("uint16", UINT16), Map.entry("int32", INT32), Map.entry("uint32", UINT32),
            Map.entry("float32", FLOAT32), Map.entry("float64", FLOAT64));

    /** Size in binary files. */
    final int bytes;
    /** Largest value of an unsigned type; 0 for others. */
    final long maxValue;

    PlyType(int bytes, long maxValue) {
        this.bytes = bytes;
        this.maxValue = maxValue;
    }

    static Optional<PlyType> of(String name) {
        return Optional.ofNullable(NAMES.get(name));
    }

    boolean isInteger() {
        return this != FLOAT32 && this != FLOAT64;
    }

    /** Reads a number of a binary file; doubles represent all types exactly. */
    double read(ByteSource source) throws IOException {
        return switch (this) {
            case INT8 -> source.int8();
            case UINT8 -> source.int8() & 0xFF;
            case INT16 -> source.int16();
            case UINT16 -> source.int16() & 0xFFFF;
            case INT32 -> source.int32();
            case UINT32 -> source.int32() & 0xFFFF_FFFFL;
            case FLOAT32 -> source.float32();
            case FLOAT64 -> source.float64();
        };
    }
}
