package lightning.format.matte;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.Stage;
import lightning.scene.material.Material;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import lightning.scene.value.Placement;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ids, names and ranks of mattes. */
class MatteTest {
    /** Examples of Cryptomatte's specification. */
    @ParameterizedTest
    @CsvSource({"bunny, 13851a76", "default, 42c9679f", "bunny_porcelain_mat, b24b26d4"})
    void ids_areThoseOfTheSpecification(String name, String id) {
        assertThat(MatteId.hex(MatteId.bits(name))).isEqualTo(id);
    }

    @Test
    void emptyText_hasTheSeedAsHash() {
        assertThat(MatteId.hash("")).isZero();
        assertThat(MatteId.bits("")).isEqualTo(0x00800000);
    }

    @Property
    void everyId_isANormalFloat(@ForAll String name) {
        float id = Float.intBitsToFloat(MatteId.bits(name));
        assertThat(Math.abs(id)).isBetween(Float.MIN_NORMAL, Float.MAX_VALUE);
    }

    @Test
    void assets_areOutermostGroups() {
        Shape hidden = shape("hidden").withVisible(false);
        NodeGroup inner = new NodeGroup("inner", Placement.IDENTITY, List.of(shape("b"), hidden));
        NodeGroup outer = new NodeGroup("outer", Placement.IDENTITY, List.of(inner, shape("c")));
        NodeGroup off = new NodeGroup("off", Placement.IDENTITY, List.of(shape("d")), false);
        Stage stage = new Stage(List.of(), List.of(shape("a"), outer, off, shape("e")));
        assertThat(MatteKind.OBJECT.names(stage)).containsExactly("a", "b", "c", "e");
        assertThat(MatteKind.ASSET.names(stage)).containsExactly("a", "outer", "outer", "e");
        assertThat(MatteKind.MATERIAL.names(stage)).containsOnly(Material.DEFAULT.name());
        assertThat(stage.shapes()).extracting(Shape::name).isEqualTo(MatteKind.OBJECT.names(stage));
    }

    private static Shape shape(String name) {
        return new Shape(Solid.SPHERE, name, Material.DEFAULT.name(), new Placement(Vec3.ZERO, Vec3.ZERO, Vec3.ONE));
    }

    @Test
    void ranks_areSortedByCoverage() {
        CoverageRanking ranking = new CoverageRanking();
        int[] samples = {10, 20, 30, 30, 20, 30, 40};
        for (int sample : samples) {
            ranking.add(sample);
        }
        assertThat(ranking.size()).isEqualTo(4);
        float[] out = new float[6];
        ranking.write(8, out);
        assertThat(out).containsExactly(id(30), 3f / 8, id(20), 2f / 8, id(10), 1f / 8);
        ranking.clear();
        ranking.write(8, out);
        assertThat(out).containsOnly(0);
    }

    private static float id(int bits) {
        return Float.intBitsToFloat(bits);
    }
}
