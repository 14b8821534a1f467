package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import lightning.base.text.GermanMessages;
import lightning.document.MaterialLibrary;
import lightning.render.image.DisplayCurve;
import lightning.sample.Slow;
import lightning.scene.Camera;
import lightning.scene.Dome;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.World;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.effects.RenderEffect;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightGroup;
import lightning.scene.material.MaterialAttribute;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** Every text of the editor has a translation in every language. */
@Slow
class EditorTextsTest {
    private static final Pattern VALUE = Pattern.compile("\\{\\d}|%[-+,]?[\\d.]*[a-z%]");
    /**
     * Texts that are the same in every language: names of products, formats and channels, colors, patterns of numbers and times, words of
     * the toolkit.
     */
    private static final Set<String> UNTRANSLATED = Set.of("Lightning", "Kelvin", "RGB", "HSV", "PSNR", "SSIM", "HH:mm:ss",
            // Printed on the console when no window can be opened.
            "cannot open a window (", "; requires a display and, on Debian, the packages libgtk-3-0 and libxtst6)",
            // Names of file types.
            "Scenes", "Tables",
            // A shortcut, a preference name, and accessible names of color fields.
            "Shortcut+Y", "glowing textures", "gel red", "gel green", "gel blue");

    private static UiTextScan source;
    private static Set<String> usedTexts;
    private static Map<String, String> german;

    @BeforeAll
    static void read() throws IOException {
        source = UiTextScan.read();
        usedTexts = new TreeSet<>(source.used());
        LightAttribute.ALL.forEach(EditorTextsTest::addTexts);
        MaterialAttribute.ALL.forEach(a -> {
            addTexts(a);
            usedTexts.add(a.help());
        });
        LightGroup.ATTRIBUTES.forEach(EditorTextsTest::addTexts);
        Camera.ATTRIBUTES.forEach(a -> usedTexts.add(a.title()));
        World.ATTRIBUTES.forEach(EditorTextsTest::addTexts);
        Dome.ATTRIBUTES.forEach(EditorTextsTest::addTexts);
        addTexts(PictureSettings.DEPTH);
        IndirectSettings.ATTRIBUTES.forEach(a -> usedTexts.add(a.title()));
        RenderEffect.ALL.forEach(e -> usedTexts.add(e.title()));
        for (var section : LightAttribute.Section.values()) {
            usedTexts.add(section.title());
        }
        for (var section : MaterialAttribute.Section.values()) {
            usedTexts.add(section.title());
        }
        for (DisplayCurve curve : DisplayCurve.values()) {
            usedTexts.add(curve.title());
        }
        for (String axis : List.of("x", "y", "z")) {
            usedTexts.add("rotate " + axis);
        }
        for (String channel : List.of("red", "green", "blue")) {
            usedTexts.addAll(List.of("gel " + channel, "color " + channel, "ambient " + channel));
        }
        MaterialLibrary.materials().forEach(m -> usedTexts.add(m.name()));
        usedTexts.remove("");
        german = GermanMessages.all();
    }

    private static void addTexts(SceneAttribute<?, ?> attribute) {
        usedTexts.add(attribute.title());
        if (attribute.kind() instanceof NumericKind<?> quantity && quantity.form() != NumericKind.Form.COLOR) {
            // Without the name of the section.
            quantity.labels().stream().map(part -> (attribute.title() + " " + part).strip()).forEach(title -> usedTexts.addAll(
                    List.of(title, title.replaceFirst("^(environment|fog (?!gain)|attenuation) ?", ""))));
        }
        if (attribute.kind() instanceof ChoiceKind<?> choice) {
            usedTexts.addAll(choice.labels());
        }
    }

    @Test
    void everyText_hasGermanTranslation() {
        assertThat(removeAll(usedTexts, german.keySet())).isEmpty();
    }

    @Test
    void germanTranslations_areAllUsed() {
        assertThat(removeAll(german.keySet(), usedTexts)).isEmpty();
    }

    @Test
    void germanTranslations_haveSamePlaceholders() {
        assertThat(german).allSatisfy((english, words) -> assertThat(placeholders(words)).as(english).isEqualTo(placeholders(english)));
    }

    private static Set<String> removeAll(Set<String> texts, Set<String> known) {
        var left = new TreeSet<>(texts);
        left.removeAll(known);
        return left;
    }

    private static Set<String> placeholders(String text) {
        return new TreeSet<>(VALUE.matcher(text).results().map(MatchResult::group).toList());
    }

    @Test
    void paneTexts_areTranslatable() {
        assertThat(source.literals()).filteredOn(text -> !UNTRANSLATED.contains(text)).isEmpty();
    }
}
