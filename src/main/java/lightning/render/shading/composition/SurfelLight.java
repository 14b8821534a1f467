package lightning.render.shading.composition;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.ray.FilmKernel;
import lightning.render.gather.ray.FilmLight;
import lightning.render.shading.BackgroundLight;
import lightning.render.shading.FilmPart;
import lightning.render.shading.FilmParts;
import lightning.render.shading.IndirectSolver;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import org.jspecify.annotations.Nullable;

/** Light of the surfels of a scene in some films, and what gather points receive of it. Different threads may write different blocks. */
public final class SurfelLight {
    private final GatherStructure structure;
    private final MaterialTable materials;
    private final FilmParts parts;
    /** Films that are computed; none is dark. */
    private final BitSet chosen;
    private final boolean reflects;
    private final float[][] albedo;
    /** Lights' diffuse sum at each surfel: red, green and blue, by film; null for films that are not computed, as the next two. */
    private final float[] @Nullable [][] direct;
    /** Light that the surfels emit, a part of the last film; null if there is none or that film is not computed. */
    private final float @Nullable [][] glow;
    /** Light that reflections show of the surfels, without what they gather; null without reflections. */
    private final float[] @Nullable [][] seen;

    /** @param chosen films to compute; none is dark */
    public SurfelLight(GatherStructure structure, MaterialTable materials, FilmParts parts, BitSet chosen) {
        this.structure = structure;
        this.materials = materials;
        this.parts = parts;
        this.chosen = chosen;
        reflects = structure.reflections() != null;
        int surfels = structure.surfelCount();
        albedo = new float[3][surfels];
        direct = new float[parts.count()][][];
        glow = chosen.get(parts.count() - 1) && glows(materials) ? new float[3][surfels] : null;
        seen = new float[parts.count()][][];
        for (int part = chosen.nextSetBit(0); part >= 0; part = chosen.nextSetBit(part + 1)) {
            direct[part] = parts.get(part).from() < parts.get(part).to() ? new float[3][surfels] : null;
            seen[part] = reflects ? new float[3][surfels] : null;
        }
    }

    /** Writes the light of a block of surfels. @param layers layer of each light; unread if the light is dark */
    public void write(int[] numbers, HitRows rows, LightLayer[] layers, SurfelShader shader) {
        shader.writeAlbedo(rows, numbers, albedo);
        if (reflects) {
            shader.start(rows);
        }
        for (int part = chosen.nextSetBit(0); part >= 0; part = chosen.nextSetBit(part + 1)) {
            if (direct[part] != null) {
                shader.writeDirectLight(rows, parts, part, layers, numbers, requireNonNull(direct[part]));
            }
            if (glow != null && isRest(part)) {
                shader.writeEmission(rows, parts, part, numbers, glow);
            }
            if (reflects) {
                shader.writeEmission(rows, parts, part, numbers, requireNonNull(seen[part]));
                shader.addShownLight(rows, parts, part, layers, numbers, requireNonNull(seen[part]));
            }
        }
    }

    /**
     * Returns the light at all points by film, as {@link IndirectSolver#solve}; null for films without.
     *
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public float[] @Nullable [][] solve(FilmKernel kernel, WorkerPool workers, Progress progress) {
        float[] @Nullable [][] light = new float[parts.count()][][];
        int[] shining = chosen.stream().filter(this::shines).toArray();
        List<IndirectSolver.Source> sources = sources(shining);
        for (int from = 0; from < shining.length; from += FilmLight.MAX_FILMS) {
            List<IndirectSolver.Source> group = sources.subList(from, Math.min(shining.length, from + FilmLight.MAX_FILMS));
            float[][][] solved = new IndirectSolver(structure, group, albedo, kernel, workers, progress).solve();
            for (int film = 0; film < group.size(); film++) {
                light[shining[from + film]] = solved[film];
            }
        }
        return light;
    }

    /** Returns whether surfels have any light in a film. */
    private boolean shines(int part) {
        return !isBlack(direct[part]) || glow != null && isRest(part) || !isBlack(seen[part])
                || !parts.background(part).equals(BackgroundLight.NONE);
    }

    private List<IndirectSolver.Source> sources(int[] films) {
        float[][] objects = structure.glow().shapes().glow(materials);
        float[][] none = new float[3][structure.surfelCount()];
        float[][] unseen = new float[3][reflects ? structure.surfelCount() : 0];
        return Arrays.stream(films).mapToObj(part -> new IndirectSolver.Source(direct[part] == null ? none : direct[part],
                glow != null && isRest(part) ? glow : none, isRest(part) ? objects : null, seen[part] == null ? unseen : seen[part],
                parts.background(part))).toList();
    }

    private boolean isRest(int part) {
        return parts.get(part).kind() == FilmPart.Kind.REST;
    }

    /** Returns whether any material glows. */
    private static boolean glows(MaterialTable materials) {
        boolean glows = false;
        for (int m = 0; m < materials.count(); m++) {
            glows |= materials.ownGlow(m, 0) > 0 || materials.ownGlow(m, 1) > 0 || materials.ownGlow(m, 2) > 0;
        }
        return glows;
    }

    private static boolean isBlack(float @Nullable [][] light) {
        if (light == null) {
            return true;
        }
        for (float[] channel : light) {
            for (float value : channel) {
                if (value > 0) {
                    return false;
                }
            }
        }
        return true;
    }
}
