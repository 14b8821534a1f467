package lightning.render.shading;

import java.util.Arrays;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitCode;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;

/**
 * Finds what anti-aliasing sees of the pixels of a tile ({@link EdgeCodes}). Holds scratch memory: one for each thread.
 *
 * <p>A pixel's code is the sum over all that its ray meets, in mirrors and through what is clear: a number for what is hit and where
 * in the tree of rays, and one for each light that shines, of the row's state and, where it is lit and its material is
 * specular, its specular term in coarse steps; and whether it came through clear shapes. A light that is larger than a point has no such steps, for its highlights are soft,
 * and none in its penumbra: a row that sees any of its samples is lit.
 */
public final class EdgeCodeBuilder {
    /** Steps of a specular term from 0 to 1; what is above 1 looks like 1. */
    private static final float STEPS = 4;
    /** More than any state and highlight. */
    private static final int TINTED = 32;

    private final int[] shapes = new int[TermKernel.MAX_ROWS];
    private final int[] lights = new int[TermKernel.MAX_ROWS];
    private final int[] mirroredShapes = new int[TermKernel.MAX_ROWS];
    private final int[] mirroredLights = new int[TermKernel.MAX_ROWS];
    private short[][] pixels = new short[1][];
    private boolean hasBounces;

    /** The number of a light, {@code light} in scene order, at a hit; {@code specular} counts where the material has it. */
    static int code(int light, int state, boolean tinted, boolean hasSpecular, float specular) {
        int highlight = state == LightRows.LIT && hasSpecular ? (int) (Math.min(specular, 1) * STEPS) : 0;
        // Who faces away and who is outside the cone look the same.
        int visibleState = state == LightRows.FACING_AWAY ? LightRows.OUTSIDE_CONE : state;
        return HitCode.atDepth(visibleState + 4 * highlight + (tinted ? TINTED : 0), 16 + light);
    }

    /** Forgets all; then the levels of a tile are added, the first one first. */
    public void begin() {
        Arrays.fill(shapes, 0);
        Arrays.fill(lights, 0);
        Arrays.fill(mirroredShapes, 0);
        Arrays.fill(mirroredLights, 0);
        hasBounces = false;
    }

    /**
     * Adds what the rays of a level hit; of the level that it is seen from, no other of the same depth was added since.
     *
     * @param level the depth of the level
     * @param nodeIndex its place among those that a pixel can have, 0 for the first
     */
    public void addShapes(int level, int nodeIndex, HitRows rows, MaterialTable materials) {
        int[] sums = level == 0 ? shapes : mirroredShapes;
        hasBounces |= level > 0;
        short[] pixel = pixelIndices(level, rows);
        for (int r = 0; r < rows.runCount; r++) {
            boolean textured = materials.isTextured(rows.runMaterial[r]);
            for (int i = rows.runStart(r); i < rows.runEnd[r]; i++) {
                int code = textured ? HitCode.withTexture(rows.code[i], rows.texelRed[i], rows.texelGreen[i], rows.texelBlue[i])
                        : rows.code[i];
                sums[pixel[i]] += HitCode.atDepth(code, nodeIndex);
            }
        }
    }

    /** The place of the level that is seen from another by rays that go on in some way. */
    public static int childIndex(int above, BounceKind bounce) {
        return 2 * above + 1 + bounce.ordinal();
    }

    /** Adds how light {@code light}, which shines, lights a level whose shapes were added just before. */
    public void addLight(int level, int nodeIndex, int light, HitRows rows, LightRows layer, MaterialTable materials) {
        int[] sums = level == 0 ? lights : mirroredLights;
        short[] pixel = pixels[level];
        for (int r = 0; r < rows.runCount; r++) {
            boolean specular = layer.specular != null && layer.visibleSamples == null && materials.isSpecular(rows.runMaterial[r]);
            for (int i = rows.runStart(r); i < rows.runEnd[r]; i++) {
                boolean tinted = layer.tint != null && layer.visibleSamples == null && layer.state(i) == LightRows.LIT
                        && (layer.tint[0][i] != 1 || layer.tint[1][i] != 1 || layer.tint[2][i] != 1);
                int code = code(light, layer.state(i), tinted, specular, specular ? layer.specular[i] : 0);
                sums[pixel[i]] += level == 0 ? code : HitCode.atDepth(code, nodeIndex);
            }
        }
    }

    /** For each row of a level the pixel that it is seen in; the levels above were asked for before. */
    private short[] pixelIndices(int level, HitRows rows) {
        if (level == pixels.length) {
            pixels = Arrays.copyOf(pixels, level + 1);
        }
        if (level == 0) {
            pixels[0] = rows.parent;
            return rows.parent;
        }
        if (pixels[level] == null) {
            pixels[level] = new short[TermKernel.MAX_ROWS];
        }
        short[] above = pixels[level - 1];
        for (int i = 0; i < rows.count; i++) {
            pixels[level][i] = above[rows.parent[i]];
        }
        return pixels[level];
    }

    /** What was added since {@link #begin}. */
    public EdgeCodes build() {
        int[] mirrorShapes = hasBounces ? mirroredShapes.clone() : null;
        int[] mirrorLights = hasBounces ? mirroredLights.clone() : null;
        return new EdgeCodes(sum(shapes, mirrorShapes), sum(lights, mirrorLights), mirrorShapes, mirrorLights);
    }

    /** The same, where the first level alone was added, with what comes over mirrors as it is known. */
    public EdgeCodes build(EdgeCodes known) {
        return new EdgeCodes(sum(shapes, known.mirroredShapes()), sum(lights, known.mirroredLights()), known.mirroredShapes(),
                known.mirroredLights());
    }

    private static int[] sum(int[] own, int[] mirrored) {
        int[] sum = own.clone();
        for (int i = 0; i < sum.length && mirrored != null; i++) {
            sum[i] += mirrored[i];
        }
        return sum;
    }
}
