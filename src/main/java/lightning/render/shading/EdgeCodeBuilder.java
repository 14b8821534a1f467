package lightning.render.shading;

import java.util.Arrays;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitCode;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;

/**
 * Builds the {@link EdgeCodes} of a tile's pixels for anti-aliasing. Holds scratch memory: use one instance per thread.
 *
 * <p>A pixel's code is a sum over all hits of its rays, in mirrors and through clear surfaces. Each hit adds a number for its shape
 * and its node in the ray tree, and one for each light that shines. A light's number combines the row's state, whether the light
 * came through clear shapes, and for lit specular rows the specular term in coarse steps. Area lights have no such steps, because
 * their highlights are soft, and no penumbra: a row that sees any sample is lit.
 */
public final class EdgeCodeBuilder {
    /** Steps of a specular term from 0 to 1; terms above 1 count as 1. */
    private static final float STEPS = 4;
    /** Exceeds every state and highlight number. */
    private static final int TINTED = 32;

    private final int[] shapes = new int[TermKernel.MAX_ROWS];
    private final int[] lights = new int[TermKernel.MAX_ROWS];
    private final int[] mirroredShapes = new int[TermKernel.MAX_ROWS];
    private final int[] mirroredLights = new int[TermKernel.MAX_ROWS];
    private short[][] pixels = new short[1][];
    private boolean hasBounces;

    /**
     * Returns the number of light {@code light}, in scene order, at a hit; {@code specular} counts if the material has a specular
     * term.
     */
    static int code(int light, int state, boolean tinted, boolean hasSpecular, float specular) {
        int highlight = state == LightRows.LIT && hasSpecular ? (int) (Math.min(specular, 1) * STEPS) : 0;
        // Rows that face away and rows outside the cone look the same.
        int visibleState = state == LightRows.FACING_AWAY ? LightRows.OUTSIDE_CONE : state;
        return HitCode.atDepth(visibleState + 4 * highlight + (tinted ? TINTED : 0), 16 + light);
    }

    /** Clears all codes. Levels of a tile are added next, the first level first. */
    public void begin() {
        Arrays.fill(shapes, 0);
        Arrays.fill(lights, 0);
        Arrays.fill(mirroredShapes, 0);
        Arrays.fill(mirroredLights, 0);
        hasBounces = false;
    }

    /**
     * Adds the shapes that a level's rays hit. Between the level above and this one, no other level of the same depth may be added.
     *
     * @param level     the depth of the level
     * @param nodeIndex the level's node in a pixel's ray tree, 0 for the first level
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

    /** Returns the node index of the level that one kind of bounce reaches. */
    public static int childIndex(int above, BounceKind bounce) {
        return 2 * above + 1 + bounce.ordinal();
    }

    /** Adds the light {@code light}, which shines, on the level whose shapes were just added. */
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

    /** Returns the pixel of each row of a level; the levels above must have been requested before. */
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

    /** Returns the codes added since {@link #begin}. */
    public EdgeCodes build() {
        int[] mirrorShapes = hasBounces ? mirroredShapes.clone() : null;
        int[] mirrorLights = hasBounces ? mirroredLights.clone() : null;
        return new EdgeCodes(sum(shapes, mirrorShapes), sum(lights, mirrorLights), mirrorShapes, mirrorLights);
    }

    /** Returns the codes if only the first level was added, with the cached parts from mirrors. */
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
