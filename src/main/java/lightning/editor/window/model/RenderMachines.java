package lightning.editor.window.model;

import javafx.beans.property.SimpleStringProperty;
import javafx.beans.property.StringProperty;

/** Which other machines the artist lets hold frames, as typed. */
public final class RenderMachines {
    private final StringProperty hosts = new SimpleStringProperty("");
    private final StringProperty certificate = new SimpleStringProperty("");

    /** Where any of them is heard: {@code render7:7800, render8}. */
    public StringProperty hostsProperty() {
        return hosts;
    }

    /** The file that all of them have. */
    public StringProperty certificateProperty() {
        return certificate;
    }

    /** As it was left. */
    public void restore(Preferences preferences) {
        hosts.set(preferences.text("machines", ""));
        certificate.set(preferences.text("certificate", ""));
    }

    /** Keeps what is restored. */
    public void save(Preferences preferences) {
        preferences.set("machines", hosts.get());
        preferences.set("certificate", certificate.get());
    }
}
