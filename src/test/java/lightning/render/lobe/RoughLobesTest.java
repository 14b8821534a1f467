package lightning.render.lobe;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import lightning.base.math.Rgb;
import lightning.render.lobe.RoughLobes.Kind;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.Sheen;
import lightning.scene.material.Transmission;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests which lobes the rays of a point have. */
class RoughLobesTest {
    private static final Material CLOTH =
            Material.of("cloth").withModel(ShadingModel.PRINCIPLED).withRoughness(0.8).withSheen(new Sheen(Rgb.WHITE, 0.5));

    @ParameterizedTest
    @ValueSource(ints = {2, 4, 8, 10, 16})
    void sheen_hasHalfOfTheRays(int side) {
        assertThat(counts(CLOTH, side)).isEqualTo(Map.of(Kind.SURFACE, side * side / 2, Kind.SHEEN, side * side / 2));
        assertThat(counts(CLOTH.withRoughness(0).withCoat(new Coat(1, 0.5, 1.5)), side))
                .isEqualTo(Map.of(Kind.COAT, side * side / 2, Kind.SHEEN, side * side / 2));
        assertThat(counts(CLOTH.withCoat(new Coat(1, 0.5, 1.5)), side))
                .isEqualTo(Map.of(Kind.SURFACE, side * side / 4, Kind.COAT, side * side / 4, Kind.SHEEN, side * side / 2));
        assertThat(counts(CLOTH.withRoughness(0), side)).isEqualTo(Map.of(Kind.SHEEN, side * side));
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 4, 8, 10, 16})
    void fewestRays_areThoseOfTheRarestLobe(int side) {
        Material coated = CLOTH.withCoat(new Coat(1, 0.5, 1.5));
        for (Material material : List.of(CLOTH, coated, CLOTH.withSheen(Sheen.NONE), coated.withSheen(Sheen.NONE), CLOTH.withRoughness(0),
                coated.withRoughness(0), frosted())) {
            assertThat(RoughLobes.of(material).fewestRays(side)).isEqualTo(Collections.min(counts(material, side).values()));
        }
    }

    private static Material frosted() {
        return CLOTH.withTransmission(Transmission.NONE.withColor(Rgb.WHITE).withIor(1.5));
    }

    /** Returns the rays of each lobe, which the lobes tell as well. */
    private static Map<Kind, Integer> counts(Material material, int side) {
        RoughLobes lobes = RoughLobes.of(material);
        Map<Kind, Integer> counts = new EnumMap<>(Kind.class);
        for (int k = 0; k < side * side; k++) {
            counts.merge(lobes.kind(k / side, k % side), 1, Integer::sum);
        }
        counts.forEach((kind, count) -> assertThat(lobes.rays(kind, side)).as("%s", kind).isEqualTo(count));
        return counts;
    }
}
