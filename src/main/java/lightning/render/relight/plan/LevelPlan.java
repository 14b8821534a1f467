package lightning.render.relight.plan;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import lightning.render.cache.CachedLight;
import lightning.render.cache.CachedScene;
import lightning.render.cache.TileLevel;
import lightning.render.shading.FilmParts;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.scene.Scene;

/**
 * Update of a level's layers.
 *
 * @param layers        one plan for each light of the target scene, in its order
 * @param droppedLights names of lights whose layers are dropped (§4.6)
 * @param materials     update of the rows of changed materials
 */
public record LevelPlan(List<LayerPlan> layers, List<String> droppedLights, MaterialUpdate materials) {
    public LevelPlan {
        layers = List.copyOf(layers);
        droppedLights = List.copyOf(droppedLights);
    }

    /**
     * Creates a plan that recomputes some lights' contributions for the shown scene and keeps the rest.
     *
     * @param known     the shown scene
     * @param refreshed selects the lights to recompute
     */
    public static LevelPlan refresh(CachedScene known, MaterialTable materials, Predicate<CachedLight> refreshed) {
        Scene scene = known.scene();
        List<LayerPlan> layers = new ArrayList<>();
        for (CachedLight light : known.lights()) {
            layers.add(LayerPlan.of(WeightedLight.of(light.light(), scene), light,
                    refreshed.test(light) ? new LightUpdate.Refresh() : new LightUpdate.Keep(), ShapeChange.NONE, scene,
                    scene.stage(), ShapeChange.NONE));
        }
        return new LevelPlan(layers, List.of(), MaterialUpdate.none(materials));
    }

    /** Returns whether nothing but weights of lights that shone or stay dark changes. */
    public boolean onlyReweights() {
        return droppedLights.isEmpty() && materials.isEmpty()
                && IntStream.range(0, layers.size()).allMatch(l -> layers.get(l).onlyReweights(l));
    }

    /**
     * Adds the films whose lights have another layer over a level's rows, which lights any before or after. A level without rows may have the
     * layers of an earlier scene.
     *
     * @param parts films of the target scene
     */
    public void addChanged(FilmParts parts, TileLevel before, TileLevel after, BitSet films) {
        for (int part = 0; part < parts.count() && after.rows().count > 0; part++) {
            for (int l = parts.get(part).from(); l < parts.get(part).to(); l++) {
                LightLayer known = layers.get(l).layerBefore(before);
                LightLayer now = after.layers()[l];
                if (known != now && (LightLayer.isLit(known) || LightLayer.isLit(now))) {
                    films.set(part);
                }
            }
        }
    }

    /**
     * Returns the cached lights after the update, with the stamps of their layers.
     *
     * @param minFalloff {@link LayerUpdater#minFalloff} of all threads
     */
    public List<CachedLight> lightsAfter(UpdateMethod method, double minFalloff) {
        List<CachedLight> lights = new ArrayList<>();
        for (LayerPlan layer : layers) {
            lights.add(new CachedLight(lights.size(), layer.light(), layer.stamp(method, minFalloff)));
        }
        return lights;
    }
}
