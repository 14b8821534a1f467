package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

class ReleaseModulesTest {
    private static final Pattern REQUIRED = Pattern.compile("requires ((?:java|jdk)\\.[a-z.]+);");

    @Test
    void releasedRuntime_hasAllModulesOfJavaThatTheProgramRequires() throws IOException {
        String release = Files.readString(Path.of("src/main/release/Release.java"));
        List<String> required = REQUIRED.matcher(Files.readString(Path.of("src/main/java/module-info.java"))).results()
                .map(match -> match.group(1)).toList();
        assertThat(required).contains("jdk.management", "jdk.incubator.vector");
        String modules = release.substring(release.indexOf("MODULES ="), release.indexOf(';', release.indexOf("MODULES =")));
        assertThat(required).allMatch(modules::contains);
    }
}
