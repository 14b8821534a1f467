package lightning.format.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Value of a header attribute, of one of the format's types. */
public sealed interface ExrAttribute {
    /** Text, stored as UTF-8. */
    record Text(String value) implements ExrAttribute {}

    /** Integer. */
    record Int(int value) implements ExrAttribute {}

    /** 32-bit float. */
    record Number(float value) implements ExrAttribute {}

    /** Point in a plane. */
    record Point(float x, float y) implements ExrAttribute {}

    /**
     * Fraction.
     *
     * @param denominator above 0
     */
    record Rational(int numerator, int denominator) implements ExrAttribute {}

    /** CIE xy coordinates of the red, green and blue primaries and of white: eight numbers. */
    record Chromaticities(List<Float> values) implements ExrAttribute {
        /** Primaries and white of Rec. ITU-R BT.709, as in sRGB. */
        public static final Chromaticities REC_709 =
                new Chromaticities(List.of(0.64f, 0.33f, 0.3f, 0.6f, 0.15f, 0.06f, 0.3127f, 0.329f));
    }

    /** 4×4 matrix, line by line. It transforms a row vector from the right: {@code p · M}. */
    record Matrix(List<Float> values) implements ExrAttribute {}

    /** Returns the type's name in a file. */
    default String type() {
        return switch (this) {
            case Text _ -> "string";
            case Int _ -> "int";
            case Number _ -> "float";
            case Point _ -> "v2f";
            case Rational _ -> "rational";
            case Chromaticities _ -> "chromaticities";
            case Matrix _ -> "m44f";
        };
    }

    /** Returns the value's bytes in a file. */
    default byte[] encode() {
        return switch (this) {
            case Text text -> text.value.getBytes(StandardCharsets.UTF_8);
            case Int number -> buffer(1).putInt(number.value).array();
            case Number number -> buffer(1).putFloat(number.value).array();
            case Point point -> buffer(2).putFloat(point.x).putFloat(point.y).array();
            case Rational rational -> buffer(2).putInt(rational.numerator).putInt(rational.denominator).array();
            case Chromaticities colors -> encode(colors.values);
            case Matrix matrix -> encode(matrix.values);
        };
    }

    private static byte[] encode(List<Float> values) {
        ByteBuffer buffer = buffer(values.size());
        values.forEach(buffer::putFloat);
        return buffer.array();
    }

    private static ByteBuffer buffer(int count) {
        return ByteBuffer.allocate(Integer.BYTES * count).order(ByteOrder.LITTLE_ENDIAN);
    }
}
