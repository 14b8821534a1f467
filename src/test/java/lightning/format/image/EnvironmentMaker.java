package lightning.format.image;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Generates the environment map in {@code textures} from a formula: a clear sky with a low sun and a warm horizon. */
public final class EnvironmentMaker {
    private static final int WIDTH = 256;
    private static final int HEIGHT = 128;
    /** Direction of the sun: to the left, 27 degrees high. */
    private static final double[] SUN = {-0.83, 0.454, -0.324};

    private EnvironmentMaker() {}

    /**
     * Writes the environment map.
     *
     * @param args output folder
     */
    public static void main(String[] args) throws IOException {
        Files.write(Path.of(args[0], "evening_sky.hdr"), evening());
    }

    static byte[] evening() {
        var out = new ByteArrayOutputStream();
        out.writeBytes(
                ("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + HEIGHT + " +X " + WIDTH + "\n").getBytes(StandardCharsets.ISO_8859_1));
        byte[] line = new byte[4 * WIDTH];
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                double polar = Math.PI * (y + 0.5) / HEIGHT;
                double azimuth = 2 * Math.PI * ((x + 0.5) / WIDTH - 0.5);
                pixel(color(StrictMath.sin(polar) * StrictMath.sin(azimuth), StrictMath.cos(polar),
                        -StrictMath.sin(polar) * StrictMath.cos(azimuth)),
                        line, x);
            }
            out.writeBytes(new byte[] {2, 2, (byte) (WIDTH >> 8), (byte) WIDTH});
            for (int pixelIndex = 0; pixelIndex < line.length; pixelIndex += 128) {
                out.write(128);
                out.write(line, pixelIndex, 128);
            }
        }
        return out.toByteArray();
    }

    private static double[] color(double x, double y, double z) {
        double sunGlow = Math.max(0, x * SUN[0] + y * SUN[1] + z * SUN[2]);
        double warmth = 0.35 + 0.65 * sunGlow * sunGlow;
        double elevation = Math.max(0, y);
        double haze = StrictMath.exp(-5 * elevation);
        double sun = 2200 * StrictMath.exp((sunGlow - 1) / 0.0004) + 3 * StrictMath.exp((sunGlow - 1) / 0.02);
        double[] zenith = {0.12, 0.27, 0.62};
        double[] horizon = {1.05 * warmth + 0.1, 0.72 * warmth + 0.16, 0.42 * warmth + 0.3};
        double[] light = {1, 0.82, 0.6};
        double[] ground = {0.11, 0.1, 0.08};
        double[] toSun = new double[3];
        for (int c = 0; c < 3; c++) {
            toSun[c] = y < 0 ? ground[c] : zenith[c] * (1 - haze) + horizon[c] * haze + sun * light[c];
        }
        return toSun;
    }

    /** Encodes 8-bit mantissas with the exponent of the largest. */
    private static void pixel(double[] color, byte[] line, int x) {
        double max = Math.max(color[0], Math.max(color[1], color[2]));
        int exponent = Math.getExponent(max) + 1;
        for (int c = 0; c < 3; c++) {
            line[c * WIDTH + x] = (byte) (int) (color[c] * Math.scalb(1.0, 8 - exponent));
        }
        line[3 * WIDTH + x] = (byte) (exponent + 128);
    }
}
