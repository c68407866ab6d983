import java.io.File;
import java.io.InputStream;
import java.util.logging.Level;
import java.util.logging.Logger;
import org.verapdf.gf.foundry.VeraGreenfieldFoundryProvider;
import org.verapdf.pdfa.Foundries;
import org.verapdf.pdfa.PDFAParser;
import org.verapdf.pdfa.flavours.PDFAFlavour;
import org.verapdf.pdfa.results.TestAssertion;
import org.verapdf.pdfa.validation.profiles.Profiles;
import org.verapdf.pdfa.validation.profiles.ValidationProfile;

/** Prints, for each standard named before a PDF, how much was checked, then a line for each violation. */
public class Validate {
    public static void main(String[] words) throws Exception {
        Logger.getLogger("").setLevel(Level.OFF);
        VeraGreenfieldFoundryProvider.initialise();
        File file = new File(words[words.length - 1]);
        for (int place = 0; place < words.length - 1; place++) {
            validate(file, words[place], PDFAFlavour.byFlavourId(words[place]));
        }
    }

    private static void validate(File file, String standard, PDFAFlavour flavour) throws Exception {
        var foundry = Foundries.defaultInstance();
        try (PDFAParser parser = foundry.createParser(file, flavour)) {
            var result = foundry.createValidator(profile(standard), false).validate(parser);
            System.out.println(standard + ": " + result.getTotalAssertions());
            for (TestAssertion assertion : result.getTestAssertions()) {
                System.out.println("  " + assertion.getRuleId() + " " + assertion.getMessage());
            }
        }
    }

    private static ValidationProfile profile(String standard) throws Exception {
        String name = standard.startsWith("ua") ? "PDFUA-" + standard.substring(2) : "PDFA-" + standard.toUpperCase();
        String path = "/org/verapdf/pdfa/validation/" + name + ".xml";
        try (InputStream profile = PDFAFlavour.class.getResourceAsStream(path)) {
            return Profiles.profileFromXml(profile);
        }
    }
}
