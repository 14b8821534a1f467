package lightning.format.image;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Generates the environment maps in {@code textures} from formulas: a clear sky with a low sun and a warm horizon, and three photo studios. Their
 * lamps are placed for a camera that looks along −z.
 */
public final class EnvironmentMaker {
    static final List<String> NAMES = List.of("evening_sky.hdr", "studio_softboxes.hdr", "studio_strips.hdr", "studio_ring.hdr");
    private static final int WIDTH = 256;
    private static final int HEIGHT = 128;
    /** Direction of the sun: to the left, 27 degrees high. */
    private static final double[] SUN = {-0.83, 0.454, -0.324};

    private EnvironmentMaker() {}

    /**
     * Writes the environment maps.
     *
     * @param args output folder
     */
    public static void main(String[] args) throws IOException {
        for (String name : NAMES) {
            Files.write(Path.of(args[0], name), map(name));
        }
    }

    /** Returns the file of an environment map. */
    static byte[] map(String name) {
        return switch (name) {
            case "evening_sky.hdr" -> file(EnvironmentMaker::sky);
            case "studio_softboxes.hdr" -> file(EnvironmentMaker::softboxes);
            case "studio_strips.hdr" -> file(EnvironmentMaker::strips);
            default -> file(EnvironmentMaker::ring);
        };
    }

    /** Radiance in a direction. */
    private interface Radiance {
        double[] at(double x, double y, double z);
    }

    private static byte[] file(Radiance radiance) {
        var out = new ByteArrayOutputStream();
        out.writeBytes(
                ("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + HEIGHT + " +X " + WIDTH + "\n").getBytes(StandardCharsets.ISO_8859_1));
        byte[] line = new byte[4 * WIDTH];
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                double polar = Math.PI * (y + 0.5) / HEIGHT;
                double azimuth = 2 * Math.PI * ((x + 0.5) / WIDTH - 0.5);
                pixel(radiance.at(StrictMath.sin(polar) * StrictMath.sin(azimuth), StrictMath.cos(polar),
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

    /** A key from the left, a larger and weaker fill from the right, and a rim light from behind. */
    private static double[] softboxes(double x, double y, double z) {
        double key = 7 * box(x, y, z, -50, 35, 22, 16);
        double fill = 2.3 * box(x, y, z, 65, 15, 26, 22);
        double rim = 6 * box(x, y, z, 160, 50, 24, 8);
        return lit(y, new double[] {key + 0.96 * fill + 0.9 * rim, 0.97 * key + fill + 0.95 * rim, 0.92 * key + 1.06 * fill + rim});
    }

    /** Two tall strips at the sides, a little behind, and a weak one above: edges of bottles and metal. */
    private static double[] strips(double x, double y, double z) {
        double sides = 9 * (box(x, y, z, -105, 12, 5, 52) + box(x, y, z, 105, 12, 5, 52));
        double top = 5 * box(x, y, z, 0, 78, 40, 7);
        return lit(y, new double[] {sides + top, sides + top, sides + top});
    }

    /** A ring around the camera. */
    private static double[] ring(double x, double y, double z) {
        double angle = StrictMath.toDegrees(StrictMath.acos(Math.clamp(z, -1, 1)));
        double ring = 14 * edge(Math.abs(angle - 19) - 5);
        return lit(y, new double[] {ring, ring, ring});
    }

    /** Adds the walls of a dark room, a little brighter above. */
    private static double[] lit(double y, double[] lamps) {
        double wall = 0.15 + 0.1 * Math.max(0, y);
        return new double[] {lamps[0] + wall, lamps[1] + wall, lamps[2] + wall};
    }

    /**
     * Returns 1 in a box seen from its middle, 0 outside, with an edge of two degrees.
     *
     * @param azimuth to the right of +z, where the camera is, degrees
     * @param elevation above the horizon, degrees
     * @param width half of the width, degrees
     * @param height half of the height, degrees
     */
    private static double box(double x, double y, double z, double azimuth, double elevation, double width, double height) {
        double turn = StrictMath.toDegrees(StrictMath.atan2(x, z)) - azimuth;
        double across = Math.abs(turn - 360 * Math.rint(turn / 360)) * Math.sqrt(Math.max(0, 1 - y * y));
        double above = Math.abs(StrictMath.toDegrees(StrictMath.asin(Math.clamp(y, -1, 1))) - elevation);
        return edge(across - width) * edge(above - height);
    }

    /** Returns 1 inside and 0 outside of an edge, at a distance from it in degrees. */
    private static double edge(double outside) {
        double t = Math.clamp((1 - outside) / 2, 0, 1);
        return t * t * (3 - 2 * t);
    }

    private static double[] sky(double x, double y, double z) {
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
