package lightning.render.shading;

import lightning.render.gather.GatherStructure;
import lightning.render.gather.RowWeigher;
import lightning.render.trace.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * Indirect light of a scene.
 *
 * @param structure its paths
 * @param films     for each film the light at each gather point in the units of the lights' diffuse sum, and at each reflection point, as
 *                  {@link IndirectSolver#solve}
 * @param edgeLight the same of films without weights, by which edges are detected
 */
public record IndirectLight(GatherStructure structure, StoredFilms films, float[] @Nullable [][] edgeLight) {
    // An array in a record: written once by its creator, never after.

    /** Returns the light of each film; null for films without. */
    public float[] @Nullable [][] light() {
        return films.colors();
    }

    /**
     * Returns the light of a film at one point: red, green, blue; then, if there are blurred reflections, the six values that it reflects.
     *
     * @param weigher weigher of its paths
     * @return null if the film has none
     */
    public float @Nullable [] at(SurfacePoint point, RowWeigher weigher, int film) {
        float[][] its = films.get(film);
        if (its == null) {
            return null;
        }
        float[] values = new float[its.length];
        weigher.weigh(point).interpolate(its, 0, values);
        return values;
    }

    /** Returns the light at all points that a picture of the films has: their sum, times their weights. */
    public float[][] sum(FilmParts parts) {
        float[][] sum = structure.noLight();
        for (int film = 0; film < parts.count(); film++) {
            float[][] its = films.get(film);
            for (int c = 0; its != null && c < sum.length; c++) {
                for (int p = 0; p < sum[c].length; p++) {
                    sum[c][p] += parts.get(film).weight().channel(c % 3) * its[c][p];
                }
            }
        }
        return sum;
    }
}
