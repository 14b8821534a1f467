package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import lightning.scene.Links;
import lightning.scene.Mesh;
import lightning.scene.Texture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The table of properties against the records of the scene: both know the ranges, and they must agree. */
class BlocksTest {
    record Case(BlockType<?> type, Property<?> property, int index) {
        @Override
        public String toString() {
            return type.keyword() + "." + property.name() + property.labels().get(index);
        }
    }

    static Stream<Case> numbers() {
        return types().flatMap(t -> t.properties().stream().filter(p -> p.form() == Property.Form.NUMBERS)
                .flatMap(p -> java.util.stream.IntStream.range(0, p.count()).mapToObj(i -> new Case(t, p, i))));
    }

    /** As if every file were there. */
    private static final SceneFiles FILES = new SceneFiles() {
        @Override
        public lightning.scene.Photometry profile(String file) {
            throw new IllegalArgumentException(file);
        }

        @Override
        public lightning.scene.Sky sky(String file) {
            throw new IllegalArgumentException(file);
        }

        @Override
        public Texture texture(String file, lightning.scene.SampleMeaning samples) {
            return new Texture(1, 1, new float[3]);
        }

        @Override
        public Mesh mesh(String file, String part) {
            return new Mesh(new float[0], new int[0], null, null, null);
        }
    };

    static Stream<BlockType<?>> types() {
        return Blocks.KEYWORDS.stream().map(k -> Blocks.of(k).orElseThrow());
    }

    @ParameterizedTest
    @MethodSource("numbers")
    void largestAndLeastNumber_areAcceptedByTheRecordToo(Case c) {
        build(c, c.property.max());
        if (c.property.min() >= 0) {
            build(c, c.property.min());
        } else {
            build(c, -c.property.max());
        }
    }

    @ParameterizedTest
    @MethodSource("numbers")
    void numberOutsideTheRange_isRefusedByTheRecordToo(Case c) {
        double step = c.property.whole() ? 1 : 0;
        double above = step + Math.nextUp(c.property.max());
        double below = Math.nextDown(c.property.min()) - step;
        for (double v : new double[] {above, below, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatThrownBy(() -> c.property.checkNumber(c.index, v)).isInstanceOf(IllegalArgumentException.class);
            if (!c.property.whole()) {
                assertThatThrownBy(() -> build(c, v)).isInstanceOf(IllegalArgumentException.class);
            }
        }
        if (c.property.whole()) {
            assertThatThrownBy(() -> build(c, c.property.max() + 1)).isInstanceOf(IllegalArgumentException.class);
            assertThatThrownBy(() -> build(c, c.property.min() - 1)).isInstanceOf(IllegalArgumentException.class);
        }
    }

    @Test
    void initialValues_areAllowed() {
        types().forEach(t -> t.properties().forEach(p -> {
            switch (p.initial()) {
                case Value.Numbers(List<Double> all) -> {
                    for (int i = 0; i < all.size(); i++) {
                        p.checkNumber(i, all.get(i));
                    }
                    p.checkTogether(p.initial());
                }
                case Value.Word(String word) -> p.checkWord(word);
                case Value.Name(String name) -> lightning.scene.Limits.name(name);
                case Value.Quoted q -> p.checkTogether(q);
                case Value.Linked(Links links) -> assertThat(links.isAll()).isTrue();
                case Value.Absent a ->
                        assertThat(p.name()).isIn("texture", "cutout", "bump", "normal_map", "gobo", "profile", "environment", "bank",
                                Blocks.FILE, Blocks.PART);
            }
        }));
    }

    @Test
    void initialBlocks_buildTheDefaultsOfTheScene() {
        assertThat(Blocks.PICTURE.builder().build("", new Values(Blocks.PICTURE.initials()::get, FILES), List.of()))
                .isEqualTo(lightning.scene.Picture.DEFAULT);
        assertThat(Blocks.CAMERA.builder().build("", new Values(Blocks.CAMERA.initials()::get, FILES), List.of()))
                .isEqualTo(lightning.scene.Camera.DEFAULT);
        assertThat(Blocks.MATERIAL.builder().build("default", new Values(Blocks.MATERIAL.initials()::get, FILES), List.of()))
                .isEqualTo(lightning.scene.Material.DEFAULT);
    }

    private static Object build(Case c, double v) {
        Map<String, Value> values = new HashMap<>(c.type.initials());
        values.put("type", new Value.Word("spot"));
        if (c.type == Blocks.MATERIAL) {
            PictureProperty.ALL.forEach(p -> values.put(p.name(), new Value.Quoted("a.png")));
        }
        values.put(Blocks.FILE, new Value.Quoted("a.ply"));
        if (c.type == Blocks.CAMERA) {
            // So that no single number puts the view along the up direction.
            values.put("from", Value.of(3, 5, 10));
            values.put("up", Value.of(1, 2, 3));
        }
        if (c.type == Blocks.SHOT) {
            // So that neither end comes behind the other.
            values.put("frames", Value.of(0, lightning.scene.shot.Shot.MAX_FRAME));
        }
        List<Double> numbers = new ArrayList<>(((Value.Numbers) values.get(c.property.name())).all());
        numbers.set(c.index, v);
        values.put(c.property.name(), new Value.Numbers(numbers));
        return c.type.builder().build("name", new Values(values::get, FILES), List.of());
    }
}
