package lightning.format.exr;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Matrix3;
import lightning.base.math.Primaries;

/** Reader for the channels R, G and B in the working space, linear Rec. 709. */
public final class ExrColorReader {
    static final List<String> COLORS = List.of("R", "G", "B");
    private static final int PRIMARIES = 6;
    private static final int RED = 0;
    private static final int GREEN = 1;
    private static final int BLUE = 2;

    private ExrColorReader() {}

    /**
     * Returns the channels of the colors: R, G and B; else those of the first layer with these; else luminance or the only channel, three
     * times.
     */
    public static List<String> channels(ExrHeader header) {
        List<String> names = header.channels().stream().map(ExrChannel::name).toList();
        if (names.containsAll(COLORS)) {
            return COLORS;
        }
        Optional<String> layer = names.stream().filter(name -> name.endsWith(".R")).map(name -> name.substring(0, name.length() - 1))
                .filter(prefix -> names.contains(prefix + "G") && names.contains(prefix + "B")).findFirst();
        if (layer.isPresent()) {
            return COLORS.stream().map(color -> layer.get() + color).toList();
        }
        String gray = names.contains("Y") ? "Y" : names.size() == 1 ? names.getFirst() : "";
        return gray.isEmpty() ? COLORS : List.of(gray, gray, gray);
    }

    /**
     * Reads colors, or gray values of a file with luminance alone. Those of a file with other chromaticities than Rec. 709 are converted, so that its white becomes white (Bradford).
     * A file without chromaticities is ACEScg if its header or the word {@code acescg} in its name says so. Colors outside Rec. 709 get negative components.
     *
     * @param sink receives each pixel as {@link ExrReader#read}, as red, green and blue
     * @throws IOException as {@link ExrReader#read}, or if the chromaticities are no color space
     */
    public static void read(ExrReader reader, ExrReader.PixelConsumer sink) throws IOException {
        Optional<Matrix3> matrix = toWorkingSpace(reader.header(), reader.fileName());
        if (matrix.isEmpty()) {
            reader.read(channels(reader.header()), sink);
            return;
        }
        double[] m = matrix.get().m();
        float[] converted = new float[COLORS.size()];
        reader.read(channels(reader.header()), (x, y, rgb) -> {
            // Infinities of different signs would cancel to NaN.
            double red = ExrPrimaries.finite(rgb[RED]);
            double green = ExrPrimaries.finite(rgb[GREEN]);
            double blue = ExrPrimaries.finite(rgb[BLUE]);
            for (int c = 0; c < converted.length; c++) {
                int row = converted.length * c;
                converted[c] = (float) (m[row] * red + m[row + 1] * green + m[row + 2] * blue);
            }
            sink.accept(x, y, converted);
        });
    }

    /**
     * Returns the matrix to the working space; empty if the file is in it or does not say. Chromaticities decide; without them, {@link
     * ExrPrimaries#declared}.
     */
    static Optional<Matrix3> toWorkingSpace(ExrHeader header, String fileName) throws IOException {
        if (!(header.attributes().get("chromaticities") instanceof ExrAttribute.Chromaticities colors)) {
            return ExrPrimaries.declared(header.attributes(), fileName).flatMap(ExrPrimaries::toRec709);
        }
        if (colors.equals(ExrAttribute.Chromaticities.REC_709)) {
            return Optional.empty();
        }
        double[] xy = colors.values().stream().mapToDouble(Float::doubleValue).toArray();
        Matrix3 matrix = new Primaries(Arrays.copyOf(xy, PRIMARIES), new double[] {xy[PRIMARIES], xy[PRIMARIES + 1]})
                .to(Primaries.REC709);
        for (double v : matrix.m()) {
            if (!Double.isFinite(v)) {
                throw new IOException("has chromaticities that are no color space: " + colors.values());
            }
        }
        return Optional.of(matrix);
    }
}
