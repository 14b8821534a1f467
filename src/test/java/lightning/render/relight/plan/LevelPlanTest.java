package lightning.render.relight.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.List;
import lightning.render.cache.TileLevel;
import lightning.render.shading.FilmParts;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.TexelColumns;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

/** Tests what the plan of a level says about its films. */
class LevelPlanTest {
    /** Mirrors that are updated on demand keep such a level when a light is added where nothing mirrors. */
    @Test
    void levelWithoutRows_changesNoFilm_whicheverLightsItKnows() {
        Scene scene = StudioScene.of(LightType.POINT);
        LevelPlan plan = new LevelPlan(List.of(), List.of(), MaterialUpdate.none(Geometry.of(scene).materials()));
        TileLevel empty = new TileLevel(new HitRows(0, TexelColumns.NONE), new LightLayer[0]);
        BitSet films = new BitSet();
        plan.addChanged(FilmParts.of(scene), empty, empty, films);
        assertThat(films.isEmpty()).isTrue();
    }
}
