package lightning.editor.window.widget;

import static org.assertj.core.api.Assertions.assertThat;

import atlantafx.base.theme.PrimerLight;
import java.io.IOException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import javafx.css.CssParser;
import javafx.css.Declaration;
import javafx.css.Stylesheet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ColorThemeTest {
    @TempDir
    private Path folder;

    @Test
    void compiledTheme_matchesItsSource() throws IOException {
        Path source = folder.resolve("theme.css");
        Path compiled = folder.resolve("theme.bss");
        try (var text = ColorTheme.class.getResourceAsStream(ColorTheme.baseTheme().getUserAgentStylesheet())) {
            Files.copy(text, source);
        }
        Stylesheet.convertToBinary(source.toFile(), compiled.toFile());
        URL shipped = ColorTheme.class.getResource(ColorTheme.baseTheme().getUserAgentStylesheetBSS());
        assertThat(rules(shipped)).isEqualTo(rules(compiled.toUri().toURL())).hasSizeGreaterThan(100_000);
    }

    /** Returns the color variables of a root rule. */
    private static Map<String, String> colors(URL sheet, String selector) throws IOException {
        return new CssParser().parse(sheet).getRules().stream()
                .filter(rule -> rule.getSelectors().stream().anyMatch(s -> s.toString().equals("*" + selector)))
                .flatMap(rule -> rule.getDeclarations().stream()).filter(d -> d.getProperty().startsWith("-color-"))
                .collect(Collectors.toMap(Declaration::getProperty, d -> d.getParsedValue().getValue().toString(), (_, last) -> last));
    }

    /** The light theme replaces the last grays of the library's palette by the first; see the style sheet. */
    @Test
    void lightTheme_matchesLibraryExceptOwnColors() throws IOException {
        Map<String, String> light = colors(ColorTheme.class.getResource(new PrimerLight().getUserAgentStylesheet()), ".root");
        Map<String, String> dark = colors(ColorTheme.class.getResource(ColorTheme.baseTheme().getUserAgentStylesheet()), ".root");
        Map<String, String> ours = colors(ColorTheme.class.getResource("light.css"), ".root:bright");
        Set<String> own = colors(ColorTheme.class.getResource("dark.css"), ".root").keySet();
        assertThat(own).hasSize(14);
        var actual = new TreeMap<>(dark);
        actual.putAll(ours);
        var expected = new TreeMap<>(light);
        expected.put("-color-base-6", light.get("-color-base-1"));
        expected.put("-color-base-7", light.get("-color-base-1"));
        actual.keySet().removeAll(own);
        expected.keySet().removeAll(own);
        assertThat(actual).isEqualTo(expected).hasSizeGreaterThan(70);
    }

    /** Returns the selectors and declarations of all rules, without array identities and file locations. */
    private static String rules(URL compiled) throws IOException {
        return Stylesheet.loadBinary(compiled).getRules().stream().map(rule -> rule.getSelectors() + "\n" + rule.getDeclarations())
                .collect(Collectors.joining("\n")).replaceAll("@[0-9a-f]+|(jar:)?file:[^<]*[.]bss", "");
    }
}
