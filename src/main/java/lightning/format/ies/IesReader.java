package lightning.format.ies;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import lightning.base.file.OrdinaryFile;
import lightning.format.mesh.MeshException;
import lightning.scene.Photometry;

/**
 * Reads files of luminous intensities: ANSI/IES LM-63 of 1986, 1991, 1995, 2002 and 2019. Labels, keywords and a table of tilts are passed over; a
 * file of tilts is not read.
 */
public final class IesReader {
    /** Bytes of a file: 1 MiB, room for every degree of a sphere. */
    public static final int BYTES = 1 << 20;

    private static final int MOST_TILTS = 1000;

    private final IesWords words;

    private IesReader(IesWords words) {
        this.words = words;
    }

    /**
     * What a file holds; its multiplier and all factors of ballast and lamps make no difference to shares of the largest intensity.
     *
     * @throws MeshException if it is no such file, has more than {@link #BYTES} bytes, or holds what is out of its range; the message says the line
     * @throws IOException   if it cannot be read
     */
    public static Photometry read(Path file) throws IOException, MeshException {
        long size = Files.size(file);
        if (size > BYTES) {
            throw new MeshException(file, "", "a file of intensities must have at most " + BYTES + " bytes, has " + size);
        }
        return new IesReader(new IesWords(file, OrdinaryFile.bytes(file, "an IES file", BYTES))).photometry();
    }

    private Photometry photometry() throws MeshException {
        if (words.tilt().equalsIgnoreCase("INCLUDE")) {
            words.whole("lamp to luminaire geometry", 1, 3);
            int tilts = words.whole("number of tilts", 1, MOST_TILTS);
            for (int i = 0; i < 2 * tilts; i++) {
                words.number("tilt", -1e9, 1e9);
            }
        }
        words.number("number of lamps", 0, 1e9);
        words.number("lumens per lamp", -1, 1e12);
        words.number("multiplier", 1e-30, 1e12);
        int vertical = words.whole("number of vertical angles", 1, BYTES);
        int horizontal = words.whole("number of horizontal angles", 1, BYTES);
        Photometry.Type type = switch (words.whole("photometric type", 1, 3)) {
            case 1 -> Photometry.Type.C;
            case 2 -> Photometry.Type.B;
            default -> Photometry.Type.A;
        };
        words.whole("type of units", 1, 2);
        for (String side : new String[] {"width", "length", "height"}) {
            words.number(side, -1e9, 1e9);
        }
        for (String factor : new String[] {"ballast factor", "file generation type", "input watts"}) {
            words.number(factor, -1e12, 1e12);
        }
        words.expect((long) vertical + horizontal + (long) vertical * horizontal);
        double[] up = angles("vertical angle", vertical, type == Photometry.Type.C ? 0 : -90, type == Photometry.Type.C ? 180 : 90);
        double[] across = angles("horizontal angle", horizontal, type == Photometry.Type.C ? 0 : -90, type == Photometry.Type.C ? 360 : 90);
        checkSymmetry(type, across[0], across[horizontal - 1]);
        return new Photometry(type, up, across, candela(vertical * horizontal));
    }

    private double[] candela(int count) throws MeshException {
        double[] candela = new double[count];
        for (int i = 0; i < count; i++) {
            candela[i] = words.number("intensity", 0, 1e12);
        }
        if (Arrays.stream(candela).allMatch(c -> c < Float.MIN_NORMAL)) {
            throw words.problem("one intensity must be above 0, found none");
        }
        return candela;
    }

    private double[] angles(String what, int count, double min, double max) throws MeshException {
        double[] angles = new double[count];
        for (int i = 0; i < count; i++) {
            angles[i] = words.number(what, min, max);
            if (i > 0 && !(angles[i] > angles[i - 1])) {
                throw words.problem(what + "s must increase, found " + angles[i] + " behind " + angles[i - 1]);
            }
        }
        return angles;
    }

    private void checkSymmetry(Photometry.Type type, double first, double last) throws MeshException {
        boolean known = type == Photometry.Type.C
                ? first == 0 && (last == 0 || last == 90 || last == 180 || last == 360) || first == 90 && last == 270
                : (first == 0 || first == -90) && last == 90 || first == 0 && last == 0;
        if (!known) {
            throw words.problem("horizontal angles must go " + (type == Photometry.Type.C ? "from 0 to 0, 90, 180 or 360, or from 90 to 270"
                    : "from -90 or 0 to 90, or be 0 alone") + ", went from " + first + " to " + last);
        }
    }
}
