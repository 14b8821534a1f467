package lightning.format.ies;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import lightning.base.file.RegularFile;
import lightning.format.mesh.MeshException;
import lightning.scene.value.Photometry;

/**
 * Reader for IES photometric files: ANSI/IES LM-63 of 1986, 1991, 1995, 2002 and 2019. Labels, keywords and an included tilt
 * table are skipped; an external tilt file is not read.
 */
public final class IesReader {
    /** Maximum file size in bytes: 1 MiB, enough for every degree of a sphere. */
    public static final int MAX_BYTES = 1 << 20;

    private static final int MAX_TILTS = 1000;

    private final IesTokens tokens;

    private IesReader(IesTokens tokens) {
        this.tokens = tokens;
    }

    /**
     * Reads a file. The multiplier and the ballast and lamp factors are ignored, since intensities are relative to the
     * largest.
     *
     * @throws MeshException if the file is invalid, larger than {@link #MAX_BYTES}, or a value is out of range; the message
     *     contains the line
     * @throws IOException if it cannot be read
     */
    public static Photometry read(Path file) throws IOException, MeshException {
        long size = Files.size(file);
        if (size > MAX_BYTES) {
            throw new MeshException(file, "", "an IES file must have at most " + MAX_BYTES + " bytes, has " + size);
        }
        return new IesReader(new IesTokens(file, RegularFile.readBytes(file, "an IES file", MAX_BYTES))).photometry();
    }

    private Photometry photometry() throws MeshException {
        if (tokens.tilt().equalsIgnoreCase("INCLUDE")) {
            tokens.integer("lamp to luminaire geometry", 1, 3);
            int tilts = tokens.integer("number of tilts", 1, MAX_TILTS);
            for (int i = 0; i < 2 * tilts; i++) {
                tokens.number("tilt", -1e9, 1e9);
            }
        }
        tokens.number("number of lamps", 0, 1e9);
        tokens.number("lumens per lamp", -1, 1e12);
        tokens.number("multiplier", 1e-30, 1e12);
        int verticalCount = tokens.integer("number of vertical angles", 1, MAX_BYTES);
        int horizontalCount = tokens.integer("number of horizontal angles", 1, MAX_BYTES);
        Photometry.Type type = switch (tokens.integer("photometric type", 1, 3)) {
            case 1 -> Photometry.Type.C;
            case 2 -> Photometry.Type.B;
            default -> Photometry.Type.A;
        };
        tokens.integer("type of units", 1, 2);
        for (String side : new String[] {"width", "length", "height"}) {
            tokens.number(side, -1e9, 1e9);
        }
        for (String factor : new String[] {"ballast factor", "file generation type", "input watts"}) {
            tokens.number(factor, -1e12, 1e12);
        }
        tokens.requireRemaining((long) verticalCount + horizontalCount + (long) verticalCount * horizontalCount);
        double[] verticalAngles =
                angles("vertical angle", verticalCount, type == Photometry.Type.C ? 0 : -90, type == Photometry.Type.C ? 180 : 90);
        double[] horizontalAngles =
                angles("horizontal angle", horizontalCount, type == Photometry.Type.C ? 0 : -90, type == Photometry.Type.C ? 360 : 90);
        double last = horizontalAngles[horizontalCount - 1];
        boolean isOpen = type == Photometry.Type.C && horizontalAngles[0] == 0 && last > 180 && last < 360;
        checkSymmetry(type, horizontalAngles[0], isOpen ? 360 : last);
        return withoutFaults(type, verticalAngles, horizontalAngles, candela(verticalCount * horizontalCount), isOpen);
    }

    /**
     * Mends what other readers mend: planes and angles that occur twice, and a last plane that is missing because it equals the first.
     *
     * @param isOpen whether the last plane is missing
     */
    private static Photometry withoutFaults(Photometry.Type type, double[] verticals, double[] horizontals, double[] candela,
            boolean isOpen) {
        int[] rows = increasing(verticals);
        List<Integer> planes = new ArrayList<>(Arrays.stream(increasing(horizontals)).boxed().toList());
        double[] angles = planes.stream().mapToDouble(p -> horizontals[p]).toArray();
        if (isOpen) {
            planes.add(planes.getFirst());
            angles = Arrays.copyOf(angles, angles.length + 1);
            angles[angles.length - 1] = 360;
        }
        double[] values = new double[rows.length * planes.size()];
        for (int p = 0; p < planes.size(); p++) {
            for (int r = 0; r < rows.length; r++) {
                values[p * rows.length + r] = candela[planes.get(p) * verticals.length + rows[r]];
            }
        }
        return new Photometry(type, Arrays.stream(rows).mapToDouble(r -> verticals[r]).toArray(), angles, values);
    }

    /** Returns the indices of angles without those that equal the one before. */
    private static int[] increasing(double[] angles) {
        return IntStream.range(0, angles.length).filter(i -> i == 0 || angles[i] > angles[i - 1]).toArray();
    }

    /** Reads intensities; small negative ones are errors of measurement. */
    private double[] candela(int count) throws MeshException {
        double[] candela = new double[count];
        for (int i = 0; i < count; i++) {
            candela[i] = Math.max(0, tokens.number("intensity", -1, 1e12));
        }
        if (Arrays.stream(candela).allMatch(c -> c < Float.MIN_NORMAL)) {
            throw tokens.problem("one intensity must be above 0, found none");
        }
        return candela;
    }

    private double[] angles(String label, int count, double min, double max) throws MeshException {
        double[] angles = new double[count];
        for (int i = 0; i < count; i++) {
            angles[i] = tokens.number(label, min, max);
            if (i > 0 && !(angles[i] >= angles[i - 1])) {
                throw tokens.problem(label + "s must increase, found " + angles[i] + " after " + angles[i - 1]);
            }
        }
        return angles;
    }

    private void checkSymmetry(Photometry.Type type, double first, double last) throws MeshException {
        boolean valid = type == Photometry.Type.C
                ? first == 0 && (last == 0 || last == 90 || last == 180 || last == 360) || first == 90 && last == 270
                : (first == 0 || first == -90) && last == 90 || first == 0 && last == 0;
        if (!valid) {
            throw tokens
                    .problem("horizontal angles must go " + (type == Photometry.Type.C ? "from 0 to 0, 90, 180 or 360, or from 90 to 270"
                            : "from -90 or 0 to 90, or be 0 alone") + ", went from " + first + " to " + last);
        }
    }
}
