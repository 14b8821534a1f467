package lightning.render.trace;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.scene.Camera;
import lightning.scene.Material;
import lightning.scene.PictureSettings;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.SceneNode;
import lightning.scene.Shape;
import lightning.scene.Solid;
import lightning.scene.World;
import net.jqwik.api.Assume;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;

/** Tests that codes differ on both sides of an edge. */
class HitCodeTest {

    private static int of(int shape, Vec3 n) {
        return HitCode.of(shape, (float) n.x(), (float) n.y(), (float) n.z());
    }

    @Property
    void perpendicularSides_differ(@ForAll @DoubleRange(min = -1, max = 1) double x, @ForAll @DoubleRange(min = -1, max = 1) double y,
            @ForAll @DoubleRange(min = -1, max = 1) double z, @ForAll @DoubleRange(min = 0, max = 7) double turn) {
        Assume.that(x * x + y * y + z * z > 0.01);
        Vec3 n = new Vec3(x, y, z).normalized();
        Vec3 side = n.cross(Math.abs(n.x()) < 0.7 ? new Vec3(1, 0, 0) : Vec3.Y).normalized();
        Vec3 across = side.times(Math.cos(turn)).plus(n.cross(side).times(Math.sin(turn)));
        assertThat(of(3, n)).isNotEqualTo(of(3, across));
    }

    @Property
    void neighboringShapes_differ(@ForAll @IntRange(min = 0, max = 999_998) int shape) {
        assertThat(of(shape, Vec3.Y)).isNotEqualTo(of(shape + 1, Vec3.Y));
    }

    /** Java's hash codes of these names are equal. */
    @Example
    void shapesWithSimilarNames_differ() {
        List<SceneNode> shapes = Stream.of("leg 1P", "leg 21", "Aa", "BB").<SceneNode>map(name -> new Shape(Solid.SPHERE, name, "m",
                Placement.IDENTITY)).toList();
        var geometry =
                new Geometry(
                        new Scene(PictureSettings.DEFAULT, Camera.DEFAULT, World.DEFAULT, List.of(Material.of("m")), shapes, List.of()));
        assertThat(IntStream.range(0, 4).map(geometry::shapeHash).boxed().distinct()).hasSize(4);
    }

    @Property
    void distantShades_differ(@ForAll @DoubleRange(min = 0, max = 0.8) double shade) {
        float dark = (float) shade;
        float light = (float) (shade + 0.15);
        assertThat(HitCode.withTexture(7, dark, dark, dark)).isNotEqualTo(HitCode.withTexture(7, light, dark, dark));
    }

    @Property
    void hitsOverDifferentMirrorCounts_differ(@ForAll int code, @ForAll @IntRange(min = 0, max = 10) int mirrors) {
        assertThat(HitCode.atDepth(code, mirrors)).isNotEqualTo(HitCode.atDepth(code, mirrors + 1));
    }
}
