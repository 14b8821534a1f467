package lightning.render.shading.composition;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import lightning.render.shading.FilmParts;
import lightning.render.shading.LightingEquation;
import lightning.render.shading.ObjectGains;
import lightning.render.shading.SumKernel;
import lightning.render.shading.SumOperands;
import lightning.render.shading.TermKernel;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;
import lightning.render.shading.layer.WeightedLayer;
import org.jspecify.annotations.Nullable;

/**
 * Sums the lights' contributions over the rows of a tile as the balanced tree of {@link LightingEquation#sum}. Holds scratch
 * columns: use one instance per thread.
 *
 * <p>A light that lights no row of the tile or has no weight adds +0. Sums are never negative, so skipping such a light changes no
 * bit. A result is valid until the next call.
 *
 * <p>If each half of the tree is a chain of lights, as for up to six lights, one pass adds them all. Otherwise the sum of the left
 * half is computed first and used as a precomputed sum.
 */
final class LightSum {
    private final SumKernel sumKernel;
    private final SumOperands diffuse = new SumOperands();
    private final SumOperands specular = new SumOperands();
    private final SumOperands grazing = new SumOperands();
    /** Lights of both chains, one after the other. */
    private final int[] chain = new int[SumOperands.MAX_LIGHTS];
    /** Sums of branches; those before {@link #usedScratch} are in use. */
    private final List<SumColumns> scratch = new ArrayList<>();
    private int usedScratch;
    /** Sums are computed for the rows {@code firstRow … rows − 1}. */
    private int firstRow;
    private int rows;
    /** Products of factors of the collected lights, by operand: of diffuse terms, and of others; allocated on first use. */
    private final float[][][] diffuseFactors = new float[SumOperands.MAX_LIGHTS][][];
    private final float[][][] specularFactors = new float[SumOperands.MAX_LIGHTS][][];
    /** Shape of each row; read only for lights with gains. */
    private int @Nullable [] owners;
    private WeightedLight[] lights = {};
    private LightLayer[] layers = {};

    LightSum(SumKernel kernel) {
        this.sumKernel = kernel;
    }

    /**
     * Returns the sum over the lights of a film in rows {@code from … count − 1}.
     *
     * @param shapes shape of each row; read only for lights with gains
     */
    SumColumns total(int from, int count, int @Nullable [] shapes, FilmParts parts, int part, LightLayer[] lightLayers) {
        return total(from, count, shapes, parts.lights(), lightLayers, parts.get(part).from(), parts.get(part).to());
    }

    /** Returns the sum over lights {@code first … end − 1}; parameters as above. */
    SumColumns total(int from, int count, int @Nullable [] shapes, WeightedLight[] sceneLights, LightLayer[] lightLayers, int first,
            int end) {
        begin(from, count, shapes, sceneLights, lightLayers);
        collectOperands(first, end);
        return sum();
    }

    /** Returns whether any light of a film lights a row. */
    static boolean isLit(FilmParts parts, int part, LightLayer[] lightLayers) {
        for (int l = parts.get(part).from(); l < parts.get(part).to(); l++) {
            if (!parts.lights()[l].isDark() && LightLayer.isLit(lightLayers[l])) {
                return true;
            }
        }
        return false;
    }

    private void begin(int from, int count, int @Nullable [] shapes, WeightedLight[] sceneLights, LightLayer[] lightLayers) {
        firstRow = from;
        rows = count;
        owners = shapes;
        lights = sceneLights;
        layers = lightLayers;
        usedScratch = 0;
        diffuse.clear();
        specular.clear();
        grazing.clear();
    }

    private boolean isActive(int light) {
        return !lights[light].isDark() && layers[light].litCount() > 0;
    }

    /** Collects the operands of lights {@code from … to − 1}. */
    private void collectOperands(int from, int to) {
        int middle = (from + to) >>> 1;
        int left = chain(from, middle, 0);
        int right = left < 0 ? -1 : chain(middle, to, left);
        if (right >= 0) {
            addChain(0, left);
            diffuse.endFirstChain();
            specular.endFirstChain();
            grazing.endFirstChain();
            addChain(left, left + right);
        } else if (to - from == 1) {
            WeightedLayer layer = (WeightedLayer) layers[from];
            diffuse.addSum(requireNonNull(layer.diffuse));
            if (layer.specular != null) {
                specular.addSum(layer.specular);
            }
            if (layer.grazing != null) {
                grazing.addSum(layer.grazing);
            }
        } else {
            SumColumns known = sum(from, middle);
            collectOperands(middle, to);
            addBranch(known);
        }
    }

    /**
     * Lists the contributing lights of {@code from … to − 1}, starting at index {@code at}, if the tree adds each of them to the
     * sum of those before. Returns their number. Returns −1 if there is no such order, no space, or a light with a stored
     * contribution.
     */
    private int chain(int from, int to, int at) {
        if (to - from < 2) {
            if (from == to || !isActive(from)) {
                return 0;
            }
            if (at == SumOperands.MAX_LIGHTS || !(layers[from] instanceof LightRows)) {
                return -1;
            }
            chain[at] = from;
            return 1;
        }
        int middle = (from + to) >>> 1;
        int left = chain(from, middle, at);
        int right = left < 0 ? -1 : chain(middle, to, at + left);
        if (right < 0 || left > 1 && right > 1) {
            return -1;
        }
        if (left == 1 && right > 1) {
            int single = chain[at];
            System.arraycopy(chain, at + 1, chain, at, right);
            chain[at + right] = single;
        }
        return left + right;
    }

    private void addChain(int from, int to) {
        for (int i = from; i < to; i++) {
            WeightedLight light = lights[chain[i]];
            LightRows layer = (LightRows) layers[chain[i]];
            int operand = diffuse.lightCount;
            float[][] factors = factors(light.gains(), layer.tint, layer.face, diffuseFactors, operand);
            diffuse.addLight(light.diffuse(), requireNonNull(layer.cosine), layer.falloff, factors);
            if (layer.specular == null && layer.grazing == null) {
                continue;
            }
            if (layer.face != null || layer.highlight != null) {
                factors = factors(light.gains(), layer.tint, layer.highlight, specularFactors, operand);
            }
            if (layer.specular != null) {
                specular.addLight(light.specular(), layer.specular, layer.falloff, factors);
            }
            if (layer.grazing != null) {
                grazing.addLight(light.specular(), layer.grazing, layer.falloff, factors);
            }
        }
    }

    /**
     * Returns the product of a light's tint, colors of its image, and gains: red, green and blue columns that are valid until the operands are
     * cleared; null if all are 1.
     *
     * @param tint    null if all are 1, as {@code colors} and {@code gains}
     * @param scratch columns for products, by operand
     */
    private float @Nullable [][] factors(@Nullable ObjectGains gains, float @Nullable [][] tint, float @Nullable [][] colors,
            float[][][] scratch, int operand) {
        if (gains == null && (tint == null || colors == null)) {
            return tint == null ? colors : tint;
        }
        float[][] columns = scratch[operand];
        if (tint == null && colors == null) {
            columns = columns == null ? new float[][] {new float[TermKernel.MAX_ROWS], null, null} : columns;
            assert gains != null && owners != null;
            gains.write(owners, firstRow, rows, null, columns[0]);
            scratch[operand] = columns;
            return new float[][] {columns[0], columns[0], columns[0]};
        }
        if (columns == null || columns[2] == null) {
            columns = new float[3][TermKernel.MAX_ROWS];
            scratch[operand] = columns;
        }
        for (int c = 0; c < 3; c++) {
            float[] factor = tint == null ? requireNonNull(colors)[c] : tint[c];
            if (tint != null && colors != null) {
                multiply(tint[c], colors[c], columns[c]);
                factor = columns[c];
            }
            if (gains != null) {
                assert owners != null;
                gains.write(owners, firstRow, rows, factor, columns[c]);
            }
        }
        return columns;
    }

    private void multiply(float[] a, float[] b, float[] to) {
        for (int i = firstRow; i < rows; i++) {
            to[i] = a[i] * b[i];
        }
    }

    private void addBranch(@Nullable SumColumns known) {
        if (known == null) {
            return;
        }
        diffuse.addSum(known.diffuse());
        if (known.hasSpecular) {
            specular.addSum(known.specular());
        }
        if (known.hasGrazing) {
            grazing.addSum(known.grazing());
        }
    }

    /** Computes the sum over lights {@code from … to − 1} in scratch columns, which stay in use; null if none contributes. */
    private @Nullable SumColumns sum(int from, int to) {
        int freeCount = usedScratch;
        collectOperands(from, to);
        if (diffuse.isEmpty()) {
            return null;
        }
        // The operands are in columns that are free afterwards.
        SumColumns sum = sum();
        scratch.set(usedScratch, scratch.set(freeCount, sum));
        usedScratch = freeCount + 1;
        diffuse.clear();
        specular.clear();
        grazing.clear();
        return sum;
    }

    /** Computes the sum of the collected operands in the next free scratch columns. */
    private SumColumns sum() {
        if (usedScratch == scratch.size()) {
            scratch.add(new SumColumns());
        }
        SumColumns sum = scratch.get(usedScratch);
        sum.isDiffuseGray = diffuse.isGray();
        sum(diffuse, sum.isDiffuseGray, sum.diffuse());
        sum.hasSpecular = !specular.isEmpty();
        sum.isSpecularGray = specular.isGray();
        if (sum.hasSpecular) {
            sum(specular, sum.isSpecularGray, sum.specular());
        }
        sum.hasGrazing = !grazing.isEmpty();
        if (sum.hasGrazing) {
            sumKernel.sum(firstRow, rows, grazing, sum.grazing());
        }
        return sum;
    }

    /** Computes a sum. @param isGray whether it is the same in all channels */
    private void sum(SumOperands operands, boolean isGray, float[][] to) {
        if (isGray) {
            operands.writeGray(firstRow, rows, to[0]);
        } else {
            sumKernel.sum(firstRow, rows, operands, to);
        }
    }
}
