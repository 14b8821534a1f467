package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import lightning.format.jen.asset.AssetSource;
import lightning.scene.asset.Texture;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.Mesh;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Ranges of the property table compared with those of the scene's records. */
class BlockTypesTest {
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

    /** Asset source in which every file exists. */
    private static final AssetSource FILES = new AssetSource() {
        @Override
        public lightning.scene.value.Photometry profile(String file) {
            throw new IllegalArgumentException(file);
        }

        @Override
        public lightning.scene.asset.EnvironmentMap environment(String file) {
            throw new IllegalArgumentException(file);
        }

        @Override
        public Texture texture(String file, lightning.scene.asset.TextureUsage samples) {
            return new Texture(1, 1, new float[3]);
        }

        @Override
        public Mesh mesh(String file, String part) {
            return new Mesh(new float[0], new int[0], null, null, null);
        }
    };

    static Stream<BlockType<?>> types() {
        return Stream.concat(BlockTypes.KEYWORDS.stream().map(k -> BlockTypes.of(k).orElseThrow()), Stream.of(BlockTypes.INDIRECT));
    }

    @ParameterizedTest
    @MethodSource("numbers")
    void limits_areAcceptedByTheRecord(Case c) {
        build(c, c.property.max());
        build(c, c.property.min());
    }

    @ParameterizedTest
    @MethodSource("numbers")
    void numberOutsideRange_isRejectedByTheRecord(Case c) {
        double step = c.property.isInteger() ? 1 : 0;
        double above = step + Math.nextUp(c.property.max());
        double below = Math.nextDown(c.property.min()) - step;
        for (double v : new double[] {above, below, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThatThrownBy(() -> c.property.checkNumber(c.index, v)).isInstanceOf(IllegalArgumentException.class);
            if (!c.property.isInteger()) {
                assertThatThrownBy(() -> build(c, v)).isInstanceOf(IllegalArgumentException.class);
            }
        }
        if (c.property.isInteger()) {
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
                    p.checkValue(p.initial());
                }
                case Value.Word(String word) -> p.checkWord(word);
                case Value.Name(String name) -> lightning.scene.value.SceneLimits.checkName(name);
                case Value.Quoted q -> p.checkValue(q);
                case Value.LinkSet(ShapeLinks links) -> assertThat(links.isAll()).isTrue();
                case Value.Gains _ -> throw new AssertionError("gains are absent by default");
                case Value.Nested n -> throw new AssertionError(n);
                case Value.Absent a ->
                        assertThat(Stream.concat(MaterialAttribute.MAPS.stream().map(MaterialAttribute::name),
                                Stream.of("gobo", "profile", "texture", "environment", "bank", "bulb", "shape", "gains", "indirect",
                                        BlockTypes.FILE, BlockTypes.PART)))
                                .contains(p.name());
            }
        }));
    }

    @Test
    void initialBlocks_buildSceneDefaults() {
        assertThat(BlockTypes.PICTURE.builder().build("", new PropertyValues(BlockTypes.PICTURE.initials()::get, FILES), List.of()))
                .isEqualTo(lightning.scene.PictureSettings.DEFAULT);
        assertThat(BlockTypes.CAMERA.builder().build("", new PropertyValues(BlockTypes.CAMERA.initials()::get, FILES), List.of()))
                .isEqualTo(lightning.scene.Camera.DEFAULT);
        assertThat(
                BlockTypes.MATERIAL.builder().build("default", new PropertyValues(BlockTypes.MATERIAL.initials()::get, FILES), List.of()))
                .isEqualTo(lightning.scene.material.Material.DEFAULT);
    }

    private static Object build(Case c, double v) {
        Map<String, Value> values = new HashMap<>(c.type.initials());
        values.put("type", new Value.Word("spot"));
        if (c.type == BlockTypes.MATERIAL) {
            TextureProperty.of(c.type).forEach(p -> values.put(p.name(), new Value.Quoted("a.png")));
        }
        values.put(BlockTypes.FILE, new Value.Quoted("a.ply"));
        if (c.type == BlockTypes.CAMERA) {
            // Keeps any single number from aligning the view with the up direction.
            values.put("from", Value.of(3, 5, 10));
            values.put("up", Value.of(1, 2, 3));
        }
        if (c.type == BlockTypes.SHOT) {
            // Keeps the near end before the far end.
            values.put("frames", Value.of(0, lightning.scene.shot.Shot.MAX_FRAME));
        }
        List<Double> numbers = new ArrayList<>(((Value.Numbers) values.get(c.property.name())).values());
        numbers.set(c.index, v);
        values.put(c.property.name(), new Value.Numbers(numbers));
        return c.type.builder().build("name", new PropertyValues(values::get, FILES), List.of());
    }
}
