package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** Tests that the files that describe the release agree with each other. */
class PackageMetadataTest {
    private static final Path LINUX = Path.of("src/main/release/linux");

    private static String find(String file, String pattern) throws IOException {
        Matcher matcher = Pattern.compile(pattern, Pattern.MULTILINE).matcher(Files.readString(Path.of(file)));
        assertThat(matcher.find()).as(file + " has " + pattern).isTrue();
        return matcher.group(1);
    }

    @Test
    void version_isThatOfTheChangelog_everywhere() throws IOException {
        String version = find("pom.xml", "<artifactId>lightning</artifactId>\\s*<version>(.*?)</version>");
        assertThat(find("docs/CHANGELOG.md", "^## ([0-9.]+)")).isEqualTo(version);
        assertThat(find("docs/CITATION.cff", "^version: \"(.*)\"$")).isEqualTo(version);
        assertThat(find(".ci/workflow.yml", "lightning-([0-9.]+)\\.cdx\\.json")).isEqualTo(version);
    }

    @Test
    void identifiers_startWithTheGroup() throws IOException {
        String group = find("pom.xml", "<groupId>(.*?)</groupId>");
        String id = find(LINUX.resolve("metainfo.xml").toString(), "<id>(.*?)</id>");
        // Desktop identifiers cannot have hyphens.
        assertThat(id).startsWith(group.replace('-', '_') + ".");
        assertThat(find("src/main/release/DebianPackage.java", "ID = \"(.*?)\"")).isEqualTo(id);
    }

    @Test
    void packageScripts_leaveOtherProgramsAlone() throws IOException {
        for (String script : new String[] {"postinst", "prerm"}) {
            assertThat(Files.readString(LINUX.resolve(script))).contains("update-alternatives").doesNotContain("ln -s", "rm -");
        }
    }
}
