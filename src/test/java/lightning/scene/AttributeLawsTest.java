package lightning.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.editor.document.LightEdits;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.Options;
import lightning.render.shading.ReferenceTracer;
import lightning.sample.AttributeArbitraries;
import lightning.sample.AttributeArbitraries.Changed;
import lightning.sample.Slow;
import lightning.sample.StudioScene;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** What holds of every attribute that the tables have, whichever: no place may forget one. */
class AttributeLawsTest {
    /** On a shape of the studio. */
    private static final String MATT = "matt";

    @Provide
    Arbitrary<Changed<Light>> lights() {
        return AttributeArbitraries.lights();
    }

    @Provide
    Arbitrary<Changed<Material>> materials() {
        return AttributeArbitraries.materials(MATT);
    }

    @Example
    void allThatARecordHoldsButItsName_isInTheTable() {
        assertThat(titles(LightAttribute.ALL)).containsExactlyInAnyOrderElementsOf(components(Light.class));
        assertThat(titles(MaterialAttribute.ALL)).containsExactlyInAnyOrderElementsOf(components(Material.class));
        // People are told whose intensity and rotation it is.
        assertThat(World.ATTRIBUTES.stream().map(Attribute::name)).containsExactlyInAnyOrderElementsOf(components(World.class));
    }

    private static List<String> titles(List<? extends Attribute<?, ?>> attributes) {
        return attributes.stream().map(Attribute::title).toList();
    }

    private static List<String> components(Class<? extends Record> type) {
        return Arrays.stream(type.getRecordComponents()).flatMap(AttributeLawsTest::names).filter(n -> !n.equals("name"))
                .map(AttributeLawsTest::words).toList();
    }

    private static String words(String component) {
        return component.replaceAll("(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    }

    /** An area's components are attributes of their light, a relief's, a clarity's and a cut-out's of their material. */
    private static Stream<String> names(RecordComponent component) {
        return component.getType() == Area.class || component.getType() == Relief.class || component.getType() == Clarity.class
                || component.getType() == Cutout.class
                        ? components(component.getType().asSubclass(Record.class)).stream() : Stream.of(component.getName());
    }

    @Property
    void valueThatWasSet_isTheValueAndNothingElseChanged(@ForAll("lights") Changed<Light> changed) {
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            if (attribute != changed.attribute()) {
                assertThat(attribute.of(changed.after())).as(attribute.title()).isEqualTo(attribute.of(changed.before()));
            }
        }
        assertThat(copied(changed.attribute(), changed.after(), changed.before())).isEqualTo(changed.after());
    }

    private static <T> T copied(Attribute<T, ?> attribute, T from, T to) {
        return attribute.copy(from, to);
    }

    @Property
    void changedAttribute_isToldInWords(@ForAll("lights") Changed<Light> light, @ForAll("materials") Changed<Material> material) {
        Scene studio = StudioScene.of(LightType.SPOT);
        assertTold(light.attribute(), light, studio.withLight(light.before()), studio.withLight(light.after()));
        assertTold(material.attribute(), material, studio.withMaterial(material.before()), studio.withMaterial(material.after()));
    }

    private static <T> void assertTold(Attribute<T, ?> attribute, Changed<T> changed, Scene before, Scene after) {
        String was = attribute.text(changed.before());
        String is = attribute.text(changed.after());
        if (!was.equals(is)) {
            assertThat(SceneChange.summary(before, after)).endsWith(": " + attribute.title() + " " + was + " → " + is);
        } else if (!changed.before().equals(changed.after())) {
            assertThat(SceneChange.summary(before, after)).endsWith(": a little");
        }
    }

    @Property
    void pastedSettings_areAllButPlaceAndSwitches(@ForAll("lights") Changed<Light> changed) {
        Scene scene = StudioScene.of(LightType.SPOT).withLight(changed.before());
        Scene pasted = LightEdits.paste(scene, StudioScene.KEY, changed.after()).or(scene);
        boolean stays = List.of(LightAttribute.POSITION, LightAttribute.DIRECTION, LightAttribute.ON, LightAttribute.SOLO,
                LightAttribute.ILLUMINATES, LightAttribute.SHADOWED_BY)
                .contains(changed.attribute());
        assertThat(pasted.lights()).containsExactly(stays ? changed.before() : changed.after());
    }

    /** What is said to be unseen is unseen, and an update by the difference that was found gives the full trace's bits. */
    @Property(tries = 400, edgeCases = EdgeCasesMode.NONE)
    @Slow
    void changedLight_isRenderedAsInFull(@ForAll("lights") Changed<Light> changed) {
        Scene studio = StudioScene.of(changed.before().type());
        assertUpdated(studio.withLight(changed.before()), studio.withLight(changed.after()), changed.attribute());
    }

    @Property(tries = 150, edgeCases = EdgeCasesMode.NONE)
    void changedMaterial_isRenderedAsInFull(@ForAll("materials") Changed<Material> changed) {
        Scene studio = StudioScene.of(LightType.SPOT);
        assertUpdated(studio.withMaterial(changed.before()), studio.withMaterial(changed.after()), changed.attribute());
    }

    private static void assertUpdated(Scene before, Scene after, Attribute<?, ?> attribute) {
        var full = new ReferenceTracer(after).trace();
        if (VisiblePart.same(before, after)) {
            assertThat(new ReferenceTracer(before).trace().sameBits(full)).as("%s is not seen", attribute).isTrue();
        }
        try (Renderer renderer = new Renderer(Options.DEFAULT.withThreads(1))) {
            renderer.render(before, Progress.NONE);
            String plan = renderer.render(after, Progress.NONE).plan().text();
            assertThat(renderer.film().sameBits(full)).as("%s: %s", attribute, plan).isTrue();
        }
    }
}
