package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import lightning.base.text.GermanTexts;
import lightning.editor.document.Dial;
import lightning.render.image.DisplayCurve;
import lightning.sample.Slow;
import lightning.scene.Attribute;
import lightning.scene.Bank;
import lightning.scene.Choice;
import lightning.scene.LightAttribute;
import lightning.scene.MaterialAttribute;
import lightning.scene.Picture;
import lightning.scene.Quantity;
import lightning.scene.World;
import lightning.scene.effects.Effect;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** All that the editor says has its words in every language. */
@Slow
class EditorTextsTest {
    private static final Pattern VALUE = Pattern.compile("\\{\\d}|%[-+,]?[\\d.]*[a-z%]");
    /** Names of products, formats and channels, colours, patterns of numbers and times, words of the window toolkit: the same everywhere. */
    private static final Set<String> SAME_EVERYWHERE = Set.of("Lightning", "Kelvin", "RGB", "HSV", "PSNR", "SSIM", "HH:mm:ss",
            // Told on the console, where no window can be.
            "no window can be opened here (", "; it takes a display and, on Debian, the packages libgtk-3-0 and libxtst6)",
            // Kinds of files.
            "Scenes", "Tables",
            // A key, a name in the preferences, names of gauges that fields ask for.
            "Shortcut+Y", "glowing textures", "gel red", "gel green", "gel blue");

    private static SourceTexts source;
    private static Set<String> asked;
    private static Map<String, String> german;

    @BeforeAll
    static void read() throws IOException {
        source = SourceTexts.read();
        asked = new TreeSet<>(source.asked());
        LightAttribute.ALL.forEach(EditorTextsTest::ask);
        MaterialAttribute.ALL.forEach(a -> {
            ask(a);
            asked.add(a.help());
        });
        Bank.ATTRIBUTES.forEach(EditorTextsTest::ask);
        World.ATTRIBUTES.forEach(EditorTextsTest::ask);
        ask(Picture.DEPTH);
        Dial.ALL.forEach(d -> asked.addAll(List.of(d.title().strip(), d.label())));
        Effect.ALL.forEach(e -> asked.add(e.title()));
        for (var section : LightAttribute.Section.values()) {
            asked.add(section.name().toLowerCase(java.util.Locale.ROOT));
        }
        for (var section : MaterialAttribute.Section.values()) {
            asked.add(section.name().toLowerCase(java.util.Locale.ROOT));
        }
        for (DisplayCurve curve : DisplayCurve.values()) {
            asked.add(curve.title());
        }
        for (String axis : List.of("x", "y", "z")) {
            asked.add("rotate " + axis);
        }
        for (String channel : List.of("red", "green", "blue")) {
            asked.addAll(List.of("gel " + channel, "colour " + channel, "ambient " + channel));
        }
        asked.remove("");
        german = GermanTexts.all();
    }

    private static void ask(Attribute<?, ?> attribute) {
        asked.add(attribute.title());
        if (attribute.kind() instanceof Quantity<?> quantity) {
            quantity.labels().forEach(label -> asked.addAll(List.of(label, (attribute.title() + " " + label).strip())));
        }
        if (attribute.kind() instanceof Choice<?> choice) {
            asked.addAll(choice.words());
        }
    }

    @Test
    void everyText_hasGermanWords() {
        assertThat(without(asked, german.keySet())).isEmpty();
    }

    @Test
    void germanWords_areAllAskedFor() {
        assertThat(without(german.keySet(), asked)).isEmpty();
    }

    @Test
    void germanWords_haveTheSameValues() {
        assertThat(german).allSatisfy((english, words) -> assertThat(values(words)).as(english).isEqualTo(values(english)));
    }

    private static Set<String> without(Set<String> texts, Set<String> known) {
        var left = new TreeSet<>(texts);
        left.removeAll(known);
        return left;
    }

    private static Set<String> values(String text) {
        return new TreeSet<>(VALUE.matcher(text).results().map(MatchResult::group).toList());
    }

    @Test
    void whatPanesSay_isAskedForInOnePlace() {
        assertThat(source.literals()).filteredOn(text -> !SAME_EVERYWHERE.contains(text)).isEmpty();
    }
}
