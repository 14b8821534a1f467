package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import lightning.scene.Attribute;
import lightning.scene.LightAttribute;
import lightning.scene.MaterialAttribute;
import lightning.scene.Quantity;
import org.junit.jupiter.api.Test;

/** The user's guide lists what the property editor shows. */
class UsersGuideTest {
    @Test
    void everyNumberAndPlaceOfALight_isInATable() throws IOException {
        Set<String> listed = listed();
        for (LightAttribute<?> attribute : LightAttribute.ALL) {
            if (attribute.kind() instanceof Quantity<?> quantity && quantity.form() != Quantity.Form.COLOR) {
                assertThat(listed).containsAll(quantity.labels().size() == 1 || quantity.isVector() ? Set.of(attribute.title())
                        : Set.copyOf(quantity.labels()));
            }
        }
    }

    @Test
    void everyAttributeOfAMaterial_isInATable() throws IOException {
        assertThat(listed()).containsAll(MaterialAttribute.ALL.stream().map(Attribute::title).toList());
    }

    /** The words in the first column of all tables, in lower case. */
    private static Set<String> listed() throws IOException {
        return Files.readString(Path.of("docs/users-guide.md")).lines().filter(line -> line.startsWith("| "))
                .flatMap(line -> Arrays.stream(line.split("\\|")[1].strip().toLowerCase(Locale.ROOT).split(", ")))
                .collect(Collectors.toSet());
    }
}
