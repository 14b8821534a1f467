package lightning.format.ocio;

import java.io.IOException;
import java.util.List;
import java.util.stream.IntStream;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.format.jen.asset.NameSuggestion;

/**
 * Displays and views of an OpenColorIO configuration.
 *
 * @param source   a file, or a name such as {@code ocio://default}
 * @param displays at least one; the first is the default
 */
public record OcioConfig(String source, List<Display> displays) {
    public OcioConfig {
        displays = List.copyOf(displays);
    }

    /**
     * Display with its views.
     *
     * @param views at least one
     */
    public record Display(String name, List<String> views, String defaultView) {}

    /** The file of the converter. */
    record Listing(List<Display> displays) {}

    /**
     * View of a configuration.
     *
     * @param display index of the display
     * @param view    index of the view in the display
     */
    public record Choice(int display, int view) {}

    /**
     * Reads a configuration.
     *
     * @throws IOException if it cannot be read or has no views, or there is no Python with OpenColorIO; the message is a sentence
     */
    public static OcioConfig read(String source, Progress progress) throws IOException {
        return OcioConverter.installed().convert(source, List.of(), progress,
                folder -> new OcioConfig(source, OcioConverter.readJson(folder.resolve("views.json"), Listing.class).displays()));
    }

    /** Returns the display of a choice. */
    public String display(Choice choice) {
        return displays.get(choice.display()).name();
    }

    /** Returns the view of a choice. */
    public String view(Choice choice) {
        return displays.get(choice.display()).views().get(choice.view());
    }

    /**
     * Returns the view of a name.
     *
     * @param name {@code DISPLAY/VIEW}; {@code DISPLAY} for its default view; empty for the default view of the default display. Names may
     *             have slashes of their own.
     * @throws IOException if there is none; the message names the closest one, or all
     */
    public Choice find(String name) throws IOException {
        for (int i = 0; i < displays.size(); i++) {
            Display display = displays.get(i);
            if (name.equals(display.name()) || name.isEmpty()) {
                return new Choice(i, Math.max(0, display.views().indexOf(display.defaultView())));
            }
            for (int j = 0; j < display.views().size(); j++) {
                if (name.equals(display.name() + "/" + display.views().get(j))) {
                    return new Choice(i, j);
                }
            }
        }
        throw unknown(name);
    }

    private IOException unknown(String name) {
        Display display = displays.stream().filter(d -> name.startsWith(d.name() + "/")).findFirst().orElse(null);
        if (display != null) {
            return unknown("display " + Quote.of(display.name()) + " has no view ", name.substring(display.name().length() + 1),
                    display.views());
        }
        List<String> names = displays.stream().map(Display::name).toList();
        // A display's name may have a slash: try each as the end of the name.
        String whole = name.indexOf('/') < 0 ? name
                : IntStream.range(0, name.length()).filter(i -> name.charAt(i) == '/').mapToObj(i -> name.substring(0, i))
                        .filter(start -> NameSuggestion.closest(start, names).isPresent()).findFirst()
                        .orElse(name.substring(0, name.indexOf('/')));
        return unknown("has no display ", whole, names);
    }

    private IOException unknown(String sentence, String name, List<String> names) {
        String hint = NameSuggestion.hint(name, names);
        return new IOException(
                Quote.path(source) + ": " + sentence + Quote.of(name) + (hint.isEmpty() ? "; it has " + Quote.list(names) : hint));
    }
}
