package lightning.scene.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import lightning.sample.StudioScene;
import lightning.scene.Scene;
import lightning.scene.light.Influence;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.node.Shape;
import org.junit.jupiter.api.Test;

class ShapeGainsTest {
    private final ShapeGains gains = ShapeGains.of("ball", 0.3).with("floor", 2);

    @Test
    void gains_areSetAndRemovedByName() {
        assertThat(gains.with("ball", 0.5).get("ball")).hasValue(0.5);
        assertThat(gains.without("ball")).isEqualTo(ShapeGains.of("floor", 2));
        assertThat(gains.without("floor").without("ball")).isEqualTo(ShapeGains.NONE);
        assertThat(gains.get("wall")).isEqualTo(Optional.empty());
        assertThat(gains.max()).isEqualTo(2);
        assertThat(ShapeGains.of("ball", 0.3).max()).isEqualTo(1);
    }

    @Test
    void invalidGains_areRejected() {
        assertThatThrownBy(() -> gains.with("ball", -1)).hasMessage("gain must be ≥ 0, was -1");
        assertThatThrownBy(() -> gains.with("ball", 101)).hasMessage("gain must be from 0 to 100, was 101");
        assertThatThrownBy(() -> new ShapeGains(List.of(new ShapeGains.Entry("a", 1), new ShapeGains.Entry("a", 2))))
                .hasMessage("gains must name each object once");
    }

    @Test
    void gains_areShownInPercent() {
        assertThat(gains.format()).isEqualTo("'ball' 30 %, 'floor' 200 %");
        assertThat(ShapeGains.NONE.format()).isEqualTo("none");
    }

    /** As links do. */
    @Test
    void gains_followRenamedAndRemovedObjects() {
        Scene studio = StudioScene.of(LightType.POINT);
        Light key = studio.lights().getFirst();
        Scene gained = studio.withLight(key.withInfluence(Influence.DEFAULT.withGains(gains)));
        Shape ball = (Shape) gained.stage().node("ball").orElseThrow();
        assertThat(gains(gained.withNode("ball", ball.withName("sphere"))).names()).containsExactly("sphere", "floor");
        assertThat(gains(gained.replaceNode("ball", List.of())).names()).containsExactly("floor");
    }

    private static ShapeGains gains(Scene scene) {
        return scene.lights().getFirst().influence().gains();
    }

    /** The largest products of intensity and gains stay within the limits that keep sums of lights finite. */
    @Test
    void weights_areLimited() {
        Light bright = Light.of("sun", LightType.POINT).withIntensity(1e30)
                .withInfluence(new Influence(true, 100, 0.5, 1, ShapeGains.of("ball", 100)));
        assertThat(bright.diffuseWeight().max()).isEqualTo(1e30);
        assertThat(bright.specularWeight().max()).isEqualTo(0.5e30);
        assertThat(bright.diffuseWeight().max() * bright.limitedGain(100)).isLessThanOrEqualTo(1e30);
        assertThat(bright.maxWeight()).isEqualTo(1e30);
        Light usual = bright.withIntensity(3);
        assertThat(usual.limitedGain(100)).isEqualTo(100);
        assertThat(usual.maxWeight()).isEqualTo(30_000);
    }
}
