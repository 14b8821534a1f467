package lightning.editor.window.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.document.manipulation.PreviewCamera;
import lightning.document.manipulation.Viewport;
import lightning.scene.Camera;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class LightMarkerTest {
    private static final PreviewCamera VIEW = new PreviewCamera(new Camera(new Vec3(0, 0, 10), Vec3.ZERO, Vec3.Y, 40));
    private static final Viewport CANVAS = new Viewport(400, 300);

    private static Light lightAt(double x, double y, double z) {
        return Light.of("light", LightType.POINT).withPosition(new Vec3(x, y, z));
    }

    @Test
    void lightInView_hasNoMarker() {
        assertThat(LightMarker.of(List.of(lightAt(0, 0, 0)), VIEW, CANVAS)).isEmpty();
    }

    @Test
    void lightOnRight_hasMarkerAtRightEdge() {
        LightMarker marker = LightMarker.of(List.of(lightAt(50, 0, 0)), VIEW, CANVAS).getFirst();
        assertThat(marker.tip().x()).isGreaterThan(380);
        assertThat(marker.tip().y()).isEqualTo(150);
        assertThat(marker.angle()).isZero();
    }

    @Test
    void lightBehindAndAbove_hasMarkerAtTopEdge() {
        LightMarker marker = LightMarker.of(List.of(lightAt(0, 5, 30)), VIEW, CANVAS).getFirst();
        assertThat(marker.tip().y()).isLessThan(20);
    }

    @Test
    void lightAtCamera_hasNoMarker() {
        assertThat(LightMarker.of(List.of(lightAt(0, 0, 10)), VIEW, CANVAS)).isEmpty();
    }

    @Test
    void marker_picksItsLight() {
        Light light = lightAt(50, 0, 0);
        LightMarker marker = LightMarker.of(List.of(light), VIEW, CANVAS).getFirst();
        assertThat(LightMarker.pick(List.of(light), VIEW, CANVAS, marker.tip())).isEqualTo(Optional.of(light));
        assertThat(LightMarker.pick(List.of(light), VIEW, CANVAS, new Viewport.Pixel(200, 150))).isEmpty();
    }

    @Property
    void everyLight_isInViewOrHasAMarkerInsideTheCanvas(@ForAll @DoubleRange(min = -99, max = 99) double x,
            @ForAll @DoubleRange(min = -99, max = 99) double y, @ForAll @DoubleRange(min = -99, max = 99) double z) {
        List<LightMarker> markers = LightMarker.of(List.of(lightAt(x, y, z)), VIEW, CANVAS);
        if (markers.isEmpty()) {
            Viewport.Pixel seen = CANVAS.project(VIEW, new Vec3(x, y, z));
            assertThat(seen.x()).isBetween(0.0, 400.0);
            assertThat(seen.y()).isBetween(0.0, 300.0);
        } else {
            assertThat(markers.getFirst().tip().x()).isBetween(0.0, 400.0);
            assertThat(markers.getFirst().tip().y()).isBetween(0.0, 300.0);
        }
    }

    @Property
    void framing_bringsEveryLightIntoView(@ForAll @DoubleRange(min = -99, max = 99) double x,
            @ForAll @DoubleRange(min = -99, max = 99) double y, @ForAll @DoubleRange(min = -99, max = 99) double z) {
        List<Light> lights = List.of(lightAt(x, y, z), lightAt(0, 1, 0));
        assertThat(LightMarker.of(lights, LightMarker.frameLights(lights, VIEW, CANVAS), CANVAS)).isEmpty();
    }

    @Test
    void framing_lightsInView_keepsView() {
        assertThat(LightMarker.frameLights(List.of(lightAt(0, 0, 0)), VIEW, CANVAS)).isEqualTo(VIEW);
        assertThat(LightMarker.frameLights(List.of(), VIEW, CANVAS)).isEqualTo(VIEW);
    }
}
