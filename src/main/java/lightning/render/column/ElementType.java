package lightning.render.column;

import java.util.Arrays;

/** What a column holds for each row. */
public enum ElementType {
    /** Read one by one: as many as there are rows. */
    BYTE(Byte.BYTES, 1),
    /** Of this and what follows a multiple of 16, so that lanes may run over the end. */
    SHORT(Short.BYTES, ElementType.LENGTH_MULTIPLE),
    INT(Integer.BYTES, ElementType.LENGTH_MULTIPLE),
    FLOAT(Float.BYTES, ElementType.LENGTH_MULTIPLE);

    /** The most rows that have columns together. */
    static final int MAX_ROWS = 1024;
    static final int LENGTH_MULTIPLE = 16;

    private final int bytes;
    private final int lengthMultiple;

    ElementType(int bytes, int lengthMultiple) {
        this.bytes = bytes;
        this.lengthMultiple = lengthMultiple;
    }

    /** The bytes of one. */
    public int bytes() {
        return bytes;
    }

    /** How many a column for {@code rows} rows holds: as many bytes, and of all else the next multiple of 16. */
    public int length(int rows) {
        return (rows + lengthMultiple - 1) / lengthMultiple * lengthMultiple;
    }

    /** A new column of them for {@code rows} rows, all 0. */
    Object column(int rows) {
        int length = length(rows);
        return switch (this) {
            case BYTE -> new byte[length];
            case SHORT -> new short[length];
            case INT -> new int[length];
            case FLOAT -> new float[length];
        };
    }

    /** A column for {@code rows} rows that begins like another; that other itself where it is shared, see {@link UniformColumns}. */
    Object copy(Object column, int rows) {
        int length = length(rows);
        return switch (this) {
            case BYTE -> Arrays.copyOf((byte[]) column, length);
            case SHORT -> Arrays.copyOf((short[]) column, length);
            case INT -> Arrays.copyOf((int[]) column, length);
            case FLOAT -> ((float[]) column).length == UniformColumns.LENGTH ? column : Arrays.copyOf((float[]) column, length);
        };
    }

    /** The bytes of a column of them, its header left out; none of one that is shared, see {@link UniformColumns}. */
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
