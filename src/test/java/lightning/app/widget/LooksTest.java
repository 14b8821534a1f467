package lightning.app.widget;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
import javafx.css.Stylesheet;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class LooksTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @EnumSource(Looks.class)
    void compiledTheme_isWhatThisJavaFxMakesOfItsSource(Looks looks) throws IOException {
        Path source = folder.resolve("theme.css");
        Path compiled = folder.resolve("theme.bss");
        try (var text = looks.getClass().getResourceAsStream(looks.theme().getUserAgentStylesheet())) {
            Files.copy(text, source);
        }
        Stylesheet.convertToBinary(source.toFile(), compiled.toFile());
        URL shipped = looks.getClass().getResource(looks.theme().getUserAgentStylesheetBSS());
        assertThat(rules(shipped)).isEqualTo(rules(compiled.toUri().toURL())).hasSizeGreaterThan(100_000);
    }

    /** Selectors and declarations of all rules; which object an array is tells nothing, nor where the file lies. */
    private static String rules(URL compiled) throws IOException {
        return Stylesheet.loadBinary(compiled).getRules().stream().map(rule -> rule.getSelectors() + "\n" + rule.getDeclarations())
                .collect(Collectors.joining("\n")).replaceAll("@[0-9a-f]+|(jar:)?file:[^<]*[.]bss", "");
    }
}
