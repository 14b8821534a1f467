package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import lightning.scene.attribute.NumericKind;
import lightning.scene.light.LightAttribute;
import lightning.scene.material.MaterialAttribute;
import org.junit.jupiter.api.Test;

/** Tests that the user's guide lists the parameters of the property editor. */
class UsersGuideTest {
    @Test
    void everyLightParameter_isInTable() throws IOException {
        Set<String> listed = listedNames();
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            if (attribute.kind() instanceof NumericKind<?> quantity && quantity.form() != NumericKind.Form.COLOR) {
                assertThat(listed).containsAll(quantity.isVector() ? List.of(attribute.title())
                        : quantity.labels().stream().map(part -> part.isEmpty() ? attribute.title()
                                : attribute.title().equals(attribute.section().title()) ? part : attribute.title() + " " + part)
                                .toList());
            }
        }
    }

    @Test
    void everyMaterialAttribute_isInTable() throws IOException {
        assertThat(listedNames()).containsAll(MaterialAttribute.ALL.stream().map(a -> a.title().toLowerCase(Locale.ROOT)).toList());
    }

    /** Returns the names in the first column of all tables, in lower case. */
    private static Set<String> listedNames() throws IOException {
        return Files.readString(Path.of("docs/users-guide.md")).lines().filter(line -> line.startsWith("| "))
                .flatMap(line -> Arrays.stream(line.split("\\|")[1].strip().toLowerCase(Locale.ROOT).split(", ")))
                .collect(Collectors.toSet());
    }
}
