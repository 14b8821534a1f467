package lightning.editor.window.mixer;

import java.util.Locale;
import lightning.base.text.Texts;
import lightning.editor.document.Channel;
import lightning.editor.window.widget.LightTypes;
import lightning.scene.Light;
import lightning.scene.Scene;

/** Which strips of the board are seen. */
enum StripFilter {
    ALL(Texts.key("All")), SHINING(Texts.key("Shining")), DARK(Texts.key("Dark")), SOLO(Texts.key("Solo")), MUTED(Texts.key("Muted")),
    BANKS(Texts.key("Banks"));

    private final String title;

    StripFilter(String title) {
        this.title = title;
    }

    @Override
    public String toString() {
        return Texts.of(title);
    }

    boolean shows(Channel channel, Scene scene) {
        return switch (this) {
            case ALL -> true;
            case SHINING -> channel.shines(scene);
            case DARK -> !channel.shines(scene);
            case SOLO -> channel.isSolo(scene);
            case MUTED -> !channel.isOn(scene);
            case BANKS -> channel instanceof Channel.OfBank;
        };
    }

    /** Whether a strip's name, its bank's or its type has the words. */
    static boolean finds(String words, Channel channel, Scene scene) {
        String all = channel.title() + switch (channel) {
            case Channel.OfLight(String name) -> scene.light(name).map(StripFilter::words).orElse("");
            case Channel.OfBank _ -> Texts.of(" bank");
            case Channel.OfEnvironment _ -> "";
        };
        String text = all.toLowerCase(Locale.ROOT);
        for (String word : words.strip().toLowerCase(Locale.ROOT).split("\\s+")) {
            if (!text.contains(word)) {
                return false;
            }
        }
        return true;
    }

    private static String words(Light light) {
        return " " + light.bank() + " " + LightTypes.title(light.type());
    }
}
