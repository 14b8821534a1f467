package lightning.format.exr;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import lightning.base.math.Matrix3;
import lightning.base.math.Primaries;

/** Linear color space of a file's colors. Lightning computes in {@link #REC_709}. */
public enum ExrPrimaries {
    /** Rec. 709 with D65. */
    REC_709("rec709", Primaries.REC709, Optional.empty()),
    /** ACEScg (Academy S-2014-004): AP1 with the white of ACES. */
    ACESCG("acescg", Primaries.AP1, Optional.of(Primaries.REC709.to(Primaries.AP1)));

    /** Name of ACEScg by the Color Interop Forum (Color Space Identifiers for files, 2025). */
    private static final String ACESCG_ID = "lin_ap1_scene";
    private static final String ID = "colorInteropID";

    private final String word;
    private final Primaries primaries;
    private final Optional<Matrix3> fromRec709;

    ExrPrimaries(String word, Primaries primaries, Optional<Matrix3> fromRec709) {
        this.word = word;
        this.primaries = primaries;
        this.fromRec709 = fromRec709;
    }

    /** Returns the keyword in options. */
    public String word() {
        return word;
    }

    /** Returns the primaries that a text of a header or a file's name declares: ACEScg, or empty. */
    static Optional<ExrPrimaries> declared(Map<String, ExrAttribute> attributes, String fileName) {
        boolean isAcescg = attributes.get(ID) instanceof ExrAttribute.Text(String id) && id.equals(ACESCG_ID)
                // As OpenImageIO writes it.
                || attributes.get("oiio:ColorSpace") instanceof ExrAttribute.Text(String space) && isAcescg(space)
                || Arrays.stream(fileName.split("[^\\p{Alnum}]+")).anyMatch(ExrPrimaries::isAcescg);
        return isAcescg ? Optional.of(ACESCG) : Optional.empty();
    }

    private static boolean isAcescg(String name) {
        return name.toLowerCase(Locale.ROOT).equals(ACESCG.word) || name.equals(ACESCG_ID);
    }

    /** Returns the header's attributes for these primaries. */
    public Map<String, ExrAttribute> attributes() {
        Map<String, ExrAttribute> attributes = new LinkedHashMap<>();
        List<Float> values =
                DoubleStream.concat(Arrays.stream(primaries.xy()), Arrays.stream(primaries.white())).mapToObj(v -> (float) v).toList();
        attributes.put("chromaticities", new ExrAttribute.Chromaticities(values));
        if (this == ACESCG) {
            attributes.put(ID, new ExrAttribute.Text(ACESCG_ID));
        }
        return attributes;
    }

    /**
     * Converts colors from Rec. 709, so that white stays white (Bradford).
     *
     * @param rgb red, green and blue of some pixels, {@code float[3][n]}; stays as it is
     * @return the same array for Rec. 709
     */
    public float[][] convert(float[][] rgb) {
        return fromRec709.map(matrix -> convert(matrix.m(), rgb)).orElse(rgb);
    }

    private static float[][] convert(double[] m, float[][] rgb) {
        int count = rgb[0].length;
        float[][] converted = new float[3][count];
        IntStream.range(0, 3).forEach(c -> {
            for (int i = 0; i < count; i++) {
                converted[c][i] =
                        (float) (m[3 * c] * finite(rgb[0][i]) + m[3 * c + 1] * finite(rgb[1][i]) + m[3 * c + 2] * finite(rgb[2][i]));
            }
        });
        return converted;
    }

    /** Returns the value, or the largest finite one in place of infinity: infinities of different signs would cancel to NaN. */
    static double finite(float value) {
        return Math.clamp(value, -Float.MAX_VALUE, Float.MAX_VALUE);
    }

    /** Returns the matrix to Rec. 709; empty if it is that. */
    Optional<Matrix3> toRec709() {
        return this == REC_709 ? Optional.empty() : Optional.of(primaries.to(Primaries.REC709));
    }
}
