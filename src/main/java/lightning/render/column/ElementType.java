package lightning.render.column;

import java.util.Arrays;

/** Type of a column's elements. */
public enum ElementType {
    /** Read one by one: columns have exactly one element per row. */
    BYTE(Byte.BYTES, 1),
    /** Columns of this and the following types are padded to a multiple of 16, so that lanes may overrun the end. */
    SHORT(Short.BYTES, ElementType.LENGTH_MULTIPLE),
    INT(Integer.BYTES, ElementType.LENGTH_MULTIPLE),
    FLOAT(Float.BYTES, ElementType.LENGTH_MULTIPLE);

    /** Maximum number of rows of a tile. */
    static final int MAX_ROWS = 1024;
    static final int LENGTH_MULTIPLE = 16;

    private final int bytes;
    private final int lengthMultiple;

    ElementType(int bytes, int lengthMultiple) {
        this.bytes = bytes;
        this.lengthMultiple = lengthMultiple;
    }

    /** Returns the bytes of one element. */
    public int bytes() {
        return bytes;
    }

    /** Returns the length of a column for {@code rows} rows: exact for bytes, otherwise the next multiple of 16. */
    public int length(int rows) {
        return (rows + lengthMultiple - 1) / lengthMultiple * lengthMultiple;
    }

    /** Allocates a column for {@code rows} rows, all 0. */
    Object column(int rows) {
        int length = length(rows);
        return switch (this) {
            case BYTE -> new byte[length];
            case SHORT -> new short[length];
            case INT -> new int[length];
            case FLOAT -> new float[length];
        };
    }

    /** Copies a column for {@code rows} rows; returns the column itself if it is shared, see {@link UniformColumns}. */
    Object copy(Object column, int rows) {
        int length = length(rows);
        return switch (this) {
            case BYTE -> Arrays.copyOf((byte[]) column, length);
            case SHORT -> Arrays.copyOf((short[]) column, length);
            case INT -> Arrays.copyOf((int[]) column, length);
            case FLOAT -> ((float[]) column).length == UniformColumns.LENGTH ? column : Arrays.copyOf((float[]) column, length);
        };
    }

    /** Returns the bytes of a column without its header; 0 for a shared one, see {@link UniformColumns}. */
    long bytes(Object column) {
        int length = switch (this) {
            case BYTE -> ((byte[]) column).length;
            case SHORT -> ((short[]) column).length;
            case INT -> ((int[]) column).length;
            case FLOAT -> ((float[]) column).length;
        };
        return length == UniformColumns.LENGTH ? 0 : (long) bytes * length;
    }
}
