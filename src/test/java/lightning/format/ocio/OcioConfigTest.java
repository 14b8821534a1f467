package lightning.format.ocio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.NotEmpty;
import net.jqwik.api.constraints.Size;
import net.jqwik.api.constraints.UniqueElements;
import org.junit.jupiter.api.Test;

class OcioConfigTest {
    private static final OcioConfig CONFIG = new OcioConfig("show.ocio", List.of(
            new OcioConfig.Display("sRGB - Display", List.of("Raw", "Film"), "Film"),
            new OcioConfig.Display("Cinema/P3", List.of("Film", "A/B"), "Film")));

    private static String found(String name) throws IOException {
        OcioConfig.Choice choice = CONFIG.find(name);
        return CONFIG.display(choice) + " > " + CONFIG.view(choice);
    }

    @Test
    void noName_isDefaultViewOfFirstDisplay() throws IOException {
        assertThat(found("")).isEqualTo("sRGB - Display > Film");
    }

    @Test
    void displayAlone_hasItsDefaultView() throws IOException {
        assertThat(found("Cinema/P3")).isEqualTo("Cinema/P3 > Film");
    }

    @Test
    void namesWithSlashes_areFound() throws IOException {
        assertThat(found("sRGB - Display/Raw")).isEqualTo("sRGB - Display > Raw");
        assertThat(found("Cinema/P3/A/B")).isEqualTo("Cinema/P3 > A/B");
    }

    @Test
    void unknownDisplay_namesTheNearest() {
        assertThatThrownBy(() -> CONFIG.find("sRGB Display/Raw")).isInstanceOf(IOException.class)
                .hasMessage("show.ocio: has no display 'sRGB Display', did you mean 'sRGB - Display'?");
        assertThatThrownBy(() -> CONFIG.find("Cinma/P3/Film"))
                .hasMessage("show.ocio: has no display 'Cinma/P3', did you mean 'Cinema/P3'?");
    }

    @Test
    void unknownView_namesTheNearest() {
        assertThatThrownBy(() -> CONFIG.find("sRGB - Display/Flim")).isInstanceOf(IOException.class)
                .hasMessage("show.ocio: display 'sRGB - Display' has no view 'Flim', did you mean 'Film'?");
    }

    @Test
    void nameFarFromAll_listsThem() {
        assertThatThrownBy(() -> CONFIG.find("television")).hasMessage(
                "show.ocio: has no display 'television'; it has 'sRGB - Display', 'Cinema/P3'");
        assertThatThrownBy(() -> CONFIG.find("Cinema/P3/unknown\nview")).hasMessage(
                "show.ocio: display 'Cinema/P3' has no view \"unknown\\nview\"; it has 'Film', 'A/B'");
    }

    @Test
    void hugeName_isShortened() {
        assertThatThrownBy(() -> CONFIG.find("x".repeat(100_000)))
                .satisfies(e -> assertThat(e.getMessage()).hasSizeLessThan(300));
    }

    @Property
    void eachView_isFoundByItsName(@ForAll @Size(min = 1, max = 5) @UniqueElements List<@NotEmpty String> displays,
            @ForAll @Size(min = 1, max = 5) @UniqueElements List<@NotEmpty String> views) throws IOException {
        var config = new OcioConfig("show.ocio", displays.stream().map(d -> new OcioConfig.Display(d, views, views.getFirst())).toList());
        for (String display : displays) {
            for (String view : views) {
                OcioConfig.Choice choice = config.find(display + "/" + view);
                // Slashes in names can make two views of one text.
                assertThat(config.display(choice) + "/" + config.view(choice)).startsWith(display.isEmpty() ? "/" : display);
            }
        }
    }
}
